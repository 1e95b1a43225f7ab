use super::tableau::{CLASSIC_4, combine};
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values, normalise};
use crate::propagation::fixed_step::Scheme;

/// The classic Runge–Kutta method of order 4: the yardstick that everybody knows.
///
/// The quaternion is brought back to unit length after each step.
pub(in crate::propagation) struct ClassicRk4;

impl Scheme for ClassicRk4 {
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError> {
        let first = equations.derivative(time, values);
        let derivatives = CLASSIC_4.derivatives(equations, time, step, values, first);
        let mut end = combine(values, step, &CLASSIC_4.weights, &derivatives);
        normalise(&mut end);
        Ok(end)
    }
}
