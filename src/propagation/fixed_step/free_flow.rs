use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::kicked::Free;
use crate::body::{AngularVelocity, Attitude};
use crate::dynamics::Problem;
use crate::propagation::{FreeRotation, PropagationError, Propagator, States};

/// The free motion in closed form, `[CFSZ08]`: the step is set by the loads alone, not by how fast the body spins.
pub(super) struct FreeFlow {
    /// The body without loads; its first state is set for each piece.
    problem: Problem,
    /// One row.
    states: States,
}

impl FreeFlow {
    pub fn new(problem: &Problem) -> Self {
        let problem = Problem { loads: Vec::new(), wants_attitude: true, wants_translation: false, ..problem.clone() };
        Self { problem, states: States::default() }
    }
}

impl Free for FreeFlow {
    fn turn(
        &mut self,
        duration: f64,
        attitude: UnitQuaternion<f64>,
        omega: Vector3<f64>,
    ) -> Result<(UnitQuaternion<f64>, Vector3<f64>), PropagationError> {
        // Backwards is forwards with all rates reversed.
        let direction = duration.signum();
        self.problem.initial.attitude = Attitude::from_world_from_body(attitude);
        self.problem.initial.angular_velocity = AngularVelocity::from_vector(direction * omega);
        FreeRotation::new(&self.problem)?.fill(&[duration.abs()], &mut self.states)?;
        let [w, x, y, z] = self.states.attitude.each_ref().map(|column| column[0]);
        let omega = Vector3::from(self.states.angular_velocity.each_ref().map(|column| column[0]));
        Ok((UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z)), direction * omega))
    }
}
