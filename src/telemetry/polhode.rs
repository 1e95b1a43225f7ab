use nalgebra::Vector3;

use super::figure::{others, symmetry_axis};
use crate::body::PrincipalMoments;
use crate::dynamics::Problem;

/// The principal axis that L goes round in the body at first, and which end of it.
///
/// Of two equal moments, the axis of the third; of three different ones, that of the greatest moment where L² > 2 T I₂, and
/// that of the least where L² < 2 T I₂. There is none on the separatrix, of a round body, and of one that does not turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Encircled {
    /// Number of the principal axis.
    pub(super) axis: usize,
    /// The end that leans less from L at first: 1 or −1.
    pub(super) sign: f64,
}

impl Encircled {
    /// Of this problem's first state, if there is one.
    #[must_use]
    pub fn of(problem: &Problem) -> Option<Self> {
        let omega = problem.initial.angular_velocity.in_body();
        let moments = problem.moments.vector();
        if omega == Vector3::zeros() || moments.min() >= moments.max() {
            return None;
        }
        let axis = match symmetry_axis(&moments) {
            Some(axis) => axis,
            None => match separatrix_distance(problem.moments, &omega) {
                distance if distance > 0.0 => moments.imin(),
                distance if distance < 0.0 => moments.imax(),
                _ => return None,
            },
        };
        Some(Self { axis, sign: 1.0_f64.copysign(omega[axis]) })
    }

    /// Whether ω moves in a body that nothing acts on: whether it has a part along the axis and one across.
    #[must_use]
    pub fn goes_round(&self, omega: &Vector3<f64>) -> bool {
        let across = others(self.axis).into_iter().any(|axis| omega[axis] != 0.0);
        across && omega[self.axis] != 0.0
    }

    /// Angle between the axis and L, rad, 0 to π; exact near both ends.
    #[must_use]
    pub fn tilt(&self, moments: PrincipalMoments, omega: &Vector3<f64>) -> f64 {
        let momentum = moments.vector().component_mul(omega);
        let [one, other] = others(self.axis);
        libm::atan2(libm::hypot(momentum[one], momentum[other]), self.sign * momentum[self.axis])
    }

    /// How far round the axis ω is, rad, −π to π, growing with time: the amplitude am u of the elliptic functions that ω is
    /// made of `[CFSZ08]`, 0 where ω along the axis of the middle moment is.
    ///
    /// With k the axis, m that of the middle moment and e the third: the angle of (ωₑ √(Iₑ|Iₖ − Iₑ|), ωₘ √(Iₘ|Iₖ − Iₘ|)),
    /// measured the way it goes. Of two equal moments, e is the axis that follows k; the angle then grows evenly.
    #[must_use]
    pub fn phase(&self, moments: PrincipalMoments, omega: &Vector3<f64>) -> f64 {
        let moments = moments.vector();
        let own = moments[self.axis];
        let [one, other] = others(self.axis);
        // The middle moment is the one nearer to that of the axis.
        let is_cyclic = (own - moments[other]).abs() <= (own - moments[one]).abs();
        let ([third, middle], cyclic) = if is_cyclic { ([one, other], 1.0) } else { ([other, one], -1.0) };
        let along = |axis: usize| omega[axis] * (moments[axis] * (own - moments[axis]).abs()).sqrt();
        let way = cyclic * self.sign * 1.0_f64.copysign(own - moments[middle]);
        libm::atan2(way * along(middle), along(third))
    }
}

/// 2 T I₂ / L² − 1, T the rotational energy: how far ω is from the separatrix; 0 of a body that stands still.
///
/// As (I₁ (I₂ − I₁) ω₁² − I₃ (I₃ − I₂) ω₃²) / L², I₁ ≤ I₂ ≤ I₃: differences of moments taken first, and none of energies.
#[must_use]
pub fn separatrix_distance(moments: PrincipalMoments, omega: &Vector3<f64>) -> f64 {
    let moments = moments.vector();
    let mut axes = [0, 1, 2];
    axes.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    let middle = moments[axes[1]];
    let part = |axis: usize| moments[axis] * (middle - moments[axis]) * (omega[axis] * omega[axis]);
    let square = moments.component_mul(omega).norm_squared();
    if square == 0.0 { 0.0 } else { (part(axes[0]) + part(axes[2])) / square }
}
