use super::Scheme;
use crate::body::{AngularVelocity, Attitude, State};
use crate::numerics::so3;
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values, state, values_of};

/// As physics engines step: rates from the old attitude and rates, then attitude and position by the new rates.
///
/// "Symplectic Euler" `[HLW06]` §I.1.2 for the translation. Of the rotation it is not: the gyroscopic term is explicit.
pub(super) struct EulerSemiImplicit;

impl Scheme for EulerSemiImplicit {
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError> {
        let push = equations.push(time, values);
        let State { attitude, angular_velocity, position, velocity } = state(values);
        let before = angular_velocity.in_body();
        let omega = before + step * equations.euler().acceleration(&before, &push.moment);
        let velocity = velocity + step * push.acceleration;
        Ok(values_of(&State {
            attitude: Attitude::from_world_from_body(attitude.world_from_body() * so3::exp(&(step * omega))),
            angular_velocity: AngularVelocity::from_vector(omega),
            position: position + step * velocity,
            velocity,
        }))
    }
}
