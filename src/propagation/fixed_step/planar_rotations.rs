use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::kicked::Free;
use crate::dynamics::Problem;
use crate::propagation::PropagationError;

/// The kinetic energy in three parts, each of which only turns the body about one principal axis.
///
/// [`McLachlan93`], `[Reich94]`: under ½ L₁²/I₁ alone the body turns about axis 1 at the constant rate L₁/I₁. One after
/// the other, 1 2 3 2 1 with halves outside, is symmetric and of order 2. Each part only rotates L in the body, so |L|
/// stays, and L in the world.
pub(super) struct PlanarRotations {
    moments: Vector3<f64>,
}

impl PlanarRotations {
    pub fn new(problem: &Problem) -> Self {
        Self { moments: problem.moments.vector() }
    }
}

impl Free for PlanarRotations {
    fn turn(
        &mut self,
        duration: f64,
        attitude: UnitQuaternion<f64>,
        omega: Vector3<f64>,
    ) -> Result<(UnitQuaternion<f64>, Vector3<f64>), PropagationError> {
        let mut momentum = omega.component_mul(&self.moments);
        let mut quaternion = attitude.into_inner();
        for (axis, share) in [(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)] {
            let angle = share * duration * (momentum[axis] / self.moments[axis]);
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let (sine, cosine) = libm::sincos(angle);
            // L stays where it is in the world: in the body it turns back.
            (momentum[next], momentum[last]) =
                (cosine * momentum[next] + sine * momentum[last], cosine * momentum[last] - sine * momentum[next]);
            let (sine, cosine) = libm::sincos(0.5 * angle);
            quaternion *= Quaternion::from_parts(cosine, Vector3::ith(axis, sine));
        }
        Ok((UnitQuaternion::new_normalize(quaternion), momentum.component_div(&self.moments)))
    }
}
