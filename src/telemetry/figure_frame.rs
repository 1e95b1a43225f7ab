use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::figure::others;
use super::{Encircled, EulerSequence, FigureAxis};
use crate::body::State;
use crate::dynamics::{Problem, momentum_in_world};

/// How precession, nutation and spin are told: the Euler angles z, x, z that lead from axes about the reference to axes about
/// the axis of figure.
///
/// Of a body that nothing acts on, the reference is L, and the axis of figure the one that L goes round in the body; of a
/// top, the reference is up (against the force), and the axis of figure that of symmetry, away from the pivot. Precession is
/// counted from the world's x axis where the reference is the world's z axis; else from where the shortest turn from z to
/// the reference takes x. Spin is counted from the principal axis that follows the axis of figure in cyclic order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FigureFrame {
    axis: usize,
    sign: f64,
    principal_from_figure: UnitQuaternion<f64>,
    reference_from_world: UnitQuaternion<f64>,
    /// Unit, world axes; `None`: L.
    up: Option<Vector3<f64>>,
}

impl FigureFrame {
    /// Of this problem, if it has an axis of figure and a reference that stands still.
    #[must_use]
    pub fn of(problem: &Problem) -> Option<Self> {
        let (axis, sign, up) = if problem.loads.is_empty() {
            let Encircled { axis, sign } = Encircled::of(problem)?;
            (axis, sign, None)
        } else {
            let figure = FigureAxis::of(problem)?;
            (figure.axis, figure.sign, Some(figure.up()?))
        };
        let reference = match up {
            Some(up) => up,
            None => momentum_in_world(problem.moments, &problem.initial).try_normalize(0.0)?,
        };
        let [x, y, z, w] = match axis {
            // Thirds of a turn about the diagonal of the three axes.
            0 => [0.5, 0.5, 0.5, 0.5],
            1 => [-0.5, -0.5, -0.5, 0.5],
            _ => [0.0, 0.0, 0.0, 1.0],
        };
        let upright = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        let upside_down = UnitQuaternion::new_unchecked(Quaternion::new(0.0, 1.0, 0.0, 0.0));
        Some(Self {
            axis,
            sign,
            principal_from_figure: if sign < 0.0 { upright * upside_down } else { upright },
            reference_from_world: shortest_to_z(&reference),
            up,
        })
    }

    /// Precession and spin, rad, −π to π, and nutation, 0 to π, in the order precession, nutation, spin.
    ///
    /// `attitude` is world from principal axes. Where axis and reference are along one line only the sum (or difference) of
    /// precession and spin is known: precession takes it all.
    #[must_use]
    pub fn angles(&self, attitude: &UnitQuaternion<f64>) -> [f64; 3] {
        EulerSequence::Zxz.angles(&(self.reference_from_world * attitude * self.principal_from_figure))
    }

    /// Their rates, rad/s. Where axis and reference are along one line all is spin.
    ///
    /// With p the reference in axes of the figure, of any length, p⊥² = p₁² + p₂²: precession |p| (p₁ω₁ + p₂ω₂)/p⊥²,
    /// nutation (p₂ω₁ − p₁ω₂)/p⊥, spin ω₃ − p₃ (p₁ω₁ + p₂ω₂)/p⊥². Where p is L the differences are of moments, taken
    /// first: nutation (I₂ − I₁) ω₁ω₂/p⊥, spin ω₃ (I₁(I₁ − I₃)ω₁² + I₂(I₂ − I₃)ω₂²)/p⊥².
    #[must_use]
    pub fn rates(&self, problem: &Problem, state: &State) -> [f64; 3] {
        let [one, other] = others(self.axis);
        let in_figure = |v: &Vector3<f64>| [v[one], self.sign * v[other], self.sign * v[self.axis]];
        let [w1, w2, w3] = in_figure(&state.angular_velocity.in_body());
        let moments = problem.moments.vector();
        let [i1, i2, i3] = [moments[one], moments[other], moments[self.axis]];
        let [p1, p2, p3] = match &self.up {
            Some(up) => in_figure(&state.attitude.to_body(up)),
            None => [i1 * w1, i2 * w2, i3 * w3],
        };
        let across = p1 * p1 + p2 * p2;
        if across == 0.0 {
            return [0.0, 0.0, w3];
        }
        let along = (p1 * w1 + p2 * w2) / across;
        let precession = libm::hypot(libm::hypot(p1, p2), p3) * along;
        let (nutation, spin) = match self.up {
            Some(_) => (p2 * w1 - p1 * w2, w3 - p3 * along),
            None => ((i2 - i1) * w1 * w2, w3 * (p1 * w1 * (i1 - i3) + p2 * w2 * (i2 - i3)) / across),
        };
        [precession, nutation / across.sqrt(), spin]
    }
}

/// The shortest turn that takes the unit vector `from` to the z axis; from −z, half a turn about x.
fn shortest_to_z(from: &Vector3<f64>) -> UnitQuaternion<f64> {
    let across = libm::hypot(from.x, from.y);
    // 1 + z, without its cancellation below the equator.
    let scalar = if from.z >= 0.0 { 1.0 + from.z } else { across * across / (1.0 - from.z) };
    if scalar == 0.0 {
        return UnitQuaternion::new_unchecked(Quaternion::new(0.0, 1.0, 0.0, 0.0));
    }
    UnitQuaternion::new_normalize(Quaternion::new(scalar, from.y, -from.x, 0.0))
}
