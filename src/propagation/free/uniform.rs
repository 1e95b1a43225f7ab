use crate::numerics::{DoubleDouble, Phase};
use crate::propagation::exact::{ExactQuaternion, Motion, QuaternionMap, Rates};

/// Rotation about an axis that stays: rest, a body with three equal moments, a spin about one principal axis.
#[derive(Debug, Clone, Copy)]
pub struct Uniform {
    omega: [f64; 3],
    /// Half the angle turned.
    half_angle: Phase,
    /// Attitude = this × (cos, sin) of the half-angle.
    attitude_map: QuaternionMap<2>,
}

impl Uniform {
    /// From ω in rad/s and a scale (power of two) that brings it near 1.
    pub fn new(omega: [f64; 3], scale: f64, attitude: ExactQuaternion) -> Self {
        let [x, y, z] = omega.map(|component| DoubleDouble::from(component * scale));
        let size = (x.square() + y.square() + z.square()).sqrt();
        let axis = [x, y, z].map(|component| if size.is_zero() { size } else { component / size });
        let turned = attitude.times(ExactQuaternion([DoubleDouble::ZERO, axis[0], axis[1], axis[2]]));
        let rate = (size * DoubleDouble::TURNS_PER_RADIAN).scale(0.5 / scale);
        Self {
            omega,
            half_angle: Phase { start: DoubleDouble::ZERO, rate },
            attitude_map: QuaternionMap::new([attitude, turned]),
        }
    }
}

impl Rates for Uniform {
    fn axes(&self) -> [usize; 3] {
        [0, 1, 2]
    }

    #[inline(always)]
    fn rates(&self, _: f64) -> [f64; 3] {
        self.omega
    }
}

impl Motion for Uniform {
    #[inline(always)]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let (sin, cos) = self.half_angle.at(time).sin_cos();
        (self.omega, self.attitude_map.unit([cos, sin]))
    }
}
