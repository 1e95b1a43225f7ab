use nalgebra::{Matrix4x2, Vector2};

use super::quaternion::{ExactQuaternion, unit};
use crate::numerics::{DoubleDouble, Phase};
use crate::propagation::States;

/// Rotation about an axis that stays: rest, a body with three equal moments, a spin about one principal axis.
#[derive(Debug, Clone, Copy)]
pub struct Uniform {
    omega: [f64; 3],
    /// Half the angle turned.
    half_angle: Phase,
    /// Attitude = this × (cos, sin) of the half-angle.
    attitude_map: Matrix4x2<f64>,
}

impl Uniform {
    /// From ω in rad/s and a scale (power of two) that brings it near 1.
    pub fn new(omega: [f64; 3], scale: f64, attitude: ExactQuaternion) -> Self {
        let [x, y, z] = omega.map(|component| DoubleDouble::from(component * scale));
        let size = (x.square() + y.square() + z.square()).sqrt();
        let axis = [x, y, z].map(|component| if size.is_zero() { size } else { component / size });
        let turned = attitude.times(ExactQuaternion([DoubleDouble::ZERO, axis[0], axis[1], axis[2]]));
        let (ExactQuaternion(at_cos), ExactQuaternion(at_sin)) = (attitude, turned);
        let rate = size / DoubleDouble::PI.scale(4.0 * scale);
        Self {
            omega,
            half_angle: Phase { start: DoubleDouble::ZERO, rate },
            attitude_map: Matrix4x2::from_fn(|row, column| [at_cos, at_sin][column][row].hi()),
        }
    }

    pub fn fill_rates(&self, states: &mut States) {
        for (column, omega) in states.angular_velocity.iter_mut().zip(self.omega) {
            column.fill(omega);
        }
    }

    pub fn fill_attitude(&self, times: &[f64], states: &mut States) {
        let [w, x, y, z] = &mut states.attitude;
        let rows = w.iter_mut().zip(x).zip(y).zip(z);
        for ((((w, x), y), z), &t) in rows.zip(times) {
            let (sin, cos) = self.half_angle.at(t).sin_cos();
            [*w, *x, *y, *z] = unit(self.attitude_map * Vector2::new(cos, sin));
        }
    }
}
