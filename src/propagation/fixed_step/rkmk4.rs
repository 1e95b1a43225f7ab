use nalgebra::Vector3;

use super::Scheme;
use crate::body::{AngularVelocity, Attitude, State};
use crate::numerics::so3;
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values, state, values_of};

/// The classical Runge–Kutta method on the group of rotations, [`MuntheKaas99`]: σ is stepped in q(t) = q(t₀) exp σ(t).
///
/// With ω in the body, σ̇ = ω + ½ σ × ω + 1/12 σ × (σ × ω) + O(σ⁴), as far as order 4 asks. q stays of unit length.
pub(super) struct Rkmk4;

/// What changes within a step, or its rate of change.
#[derive(Clone, Copy)]
struct Change {
    sigma: Vector3<f64>,
    omega: Vector3<f64>,
    position: Vector3<f64>,
    velocity: Vector3<f64>,
}

impl Change {
    const NONE: Self = Self { sigma: ZERO, omega: ZERO, position: ZERO, velocity: ZERO };

    fn plus(self, factor: f64, other: &Self) -> Self {
        Self {
            sigma: self.sigma + factor * other.sigma,
            omega: self.omega + factor * other.omega,
            position: self.position + factor * other.position,
            velocity: self.velocity + factor * other.velocity,
        }
    }

    fn applied_to(&self, start: &State) -> State {
        let attitude = start.attitude.world_from_body() * so3::exp(&self.sigma);
        State {
            attitude: Attitude::from_world_from_body(attitude),
            angular_velocity: AngularVelocity::from_vector(start.angular_velocity.in_body() + self.omega),
            position: start.position + self.position,
            velocity: start.velocity + self.velocity,
        }
    }
}

const ZERO: Vector3<f64> = Vector3::new(0.0, 0.0, 0.0);

impl Scheme for Rkmk4 {
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError> {
        let start = state(values);
        let mut rate = |node: f64, change: &Change| {
            let moved = change.applied_to(&start);
            let push = equations.push(time + node * step, &values_of(&moved));
            let omega = moved.angular_velocity.in_body();
            let turned = change.sigma.cross(&omega);
            Change {
                sigma: omega + 0.5 * turned + change.sigma.cross(&turned) / 12.0,
                omega: equations.euler().acceleration(&omega, &push.moment),
                position: moved.velocity,
                velocity: push.acceleration,
            }
        };
        let first = rate(0.0, &Change::NONE);
        let second = rate(0.5, &Change::NONE.plus(0.5 * step, &first));
        let third = rate(0.5, &Change::NONE.plus(0.5 * step, &second));
        let fourth = rate(1.0, &Change::NONE.plus(step, &third));
        let change = Change::NONE
            .plus(step / 6.0, &first)
            .plus(step / 3.0, &second)
            .plus(step / 3.0, &third)
            .plus(step / 6.0, &fourth);
        Ok(values_of(&change.applied_to(&start)))
    }
}
