use nalgebra::{UnitQuaternion, Vector3};

use super::Scheme;
use crate::body::{AngularVelocity, Attitude, State};
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, RATES, Values, state, values_of};

/// The rotation of a body on which nothing acts, forwards or backwards in time.
pub(super) trait Free: Send {
    /// World from principal axes, and ω in principal axes, after `duration` s.
    fn turn(
        &mut self,
        duration: f64,
        attitude: UnitQuaternion<f64>,
        omega: Vector3<f64>,
    ) -> Result<(UnitQuaternion<f64>, Vector3<f64>), PropagationError>;
}

/// Free motion between kicks: half the loads' impulse before it and half after, composed to a higher order.
///
/// The kick is the exact flow of ω̇ = I⁻¹ (τ − c ω) − b ω, v̇ = a at a fixed attitude; explicit time goes with the free
/// motion. A step of order 2 and its compositions are symmetric, and symplectic where the loads have a potential.
pub(super) struct Kicked<F> {
    free: F,
    composition: &'static [f64],
}

impl<F: Free> Kicked<F> {
    pub fn new(free: F, composition: &'static [f64]) -> Self {
        Self { free, composition }
    }
}

impl<F: Free> Scheme for Kicked<F> {
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError> {
        let mut now = time;
        let mut state = state(values);
        let mut waiting = 0.0;
        for weight in self.composition {
            let duration = weight * step;
            // The last half kick of a stage and the first of the next are one.
            kick(equations, now, waiting + 0.5 * duration, &mut state);
            let (attitude, omega) =
                self.free.turn(duration, state.attitude.world_from_body(), state.angular_velocity.in_body())?;
            state.attitude = Attitude::from_world_from_body(attitude);
            state.angular_velocity = AngularVelocity::from_vector(omega);
            state.position += duration * state.velocity;
            now += duration;
            waiting = 0.5 * duration;
        }
        kick(equations, now, waiting, &mut state);
        Ok(values_of(&state))
    }
}

fn kick(equations: &mut Equations, time: f64, duration: f64, state: &mut State) {
    let mut at_rest = values_of(state);
    at_rest[RATES].fill(0.0);
    let push = equations.push(time, &at_rest);
    let loads = &equations.span().loads;
    let (inertia, damping, brake) = (equations.euler().inertia(), loads.damping, loads.brake);
    let omega = state.angular_velocity.in_body().zip_zip_map(&inertia, &push.moment, |omega, inertia, moment| {
        let decay = damping / inertia + brake;
        let mean = mean_of_exponential(-decay * duration);
        omega + duration * mean * (moment / inertia - decay * omega)
    });
    state.angular_velocity = AngularVelocity::from_vector(omega);
    state.velocity += duration * push.acceleration;
}

/// (eˣ − 1)/x, the mean of the exponential from 0 to x.
fn mean_of_exponential(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::expm1(x) / x }
}
