use super::equations::{Equations, Values, normalise};
use super::tableau::{CLASSIC_4, combine};
use crate::dynamics::{Problem, TorqueModel};
use crate::propagation::sampling::check_times;
use crate::propagation::{Effort, PropagationError, Propagator, States};

/// The classic Runge–Kutta method of order 4 at a fixed step: the yardstick that everybody knows.
///
/// From one sample time or window edge to the next it takes a whole number of equal steps, none longer than asked for,
/// so that it lands on all of them; the quaternion is brought back to unit length after each step.
pub struct Rk4 {
    equations: Equations,
    step: f64,
    time: f64,
    values: Values,
    steps: u64,
}

impl Rk4 {
    /// From a problem and the longest step, s.
    ///
    /// # Errors
    /// [`PropagationError::NotCovered`] if the step is not positive and finite, a force moves a body of unknown mass,
    /// or two orbits act at once.
    pub fn new(problem: &Problem, step: f64) -> Result<Self, PropagationError> {
        Self::build(problem, None, step)
    }

    /// The same with a moment of the caller's own beside the problem's loads.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn with_model(
        problem: &Problem,
        model: Box<dyn TorqueModel + Send>,
        step: f64,
    ) -> Result<Self, PropagationError> {
        Self::build(problem, Some(model), step)
    }

    fn build(
        problem: &Problem,
        model: Option<Box<dyn TorqueModel + Send>>,
        step: f64,
    ) -> Result<Self, PropagationError> {
        let not_covered = |rule| PropagationError::NotCovered { method: "RK4", rule };
        if !(step > 0.0 && step < f64::INFINITY) {
            return Err(not_covered("its step must be positive and finite"));
        }
        let equations = Equations::new(problem, model).map_err(|error| not_covered(error.rule()))?;
        Ok(Self { values: equations.initial(), equations, step, time: 0.0, steps: 0 })
    }

    /// Steps to `end`, within the current span.
    fn step_to(&mut self, end: f64) -> Result<(), PropagationError> {
        let (start, length) = (self.time, end - self.time);
        if length <= 0.0 {
            return Ok(());
        }
        // A multiple of the step that rounding put just above it is not worth a step more.
        let count = (length / self.step * (1.0 - 4.0 * f64::EPSILON)).ceil().max(1.0);
        let step = length / count;
        if start + step == start {
            return Err(PropagationError::StepTooSmall { time: start, step });
        }
        let mut done = 0.0;
        while done < count {
            // From the count, not a running sum: t = start + n h.
            self.time = start + done * step;
            let first = self.equations.derivative(self.time, &self.values);
            let derivatives = CLASSIC_4.derivatives(&mut self.equations, self.time, step, &self.values, first);
            let mut values = combine(&self.values, step, &CLASSIC_4.weights, &derivatives);
            normalise(&mut values);
            if values.iter().any(|value| !value.is_finite()) {
                return Err(PropagationError::NotFinite { time: self.time });
            }
            self.values = values;
            self.steps += 1;
            done += 1.0;
        }
        self.time = end;
        Ok(())
    }
}

impl Propagator for Rk4 {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.time)?;
        self.equations.reset(states, times.len());
        for (row, &time) in times.iter().enumerate() {
            while time > self.equations.span().end {
                self.step_to(self.equations.span().end)?;
                self.equations.next_span();
            }
            self.step_to(time)?;
            self.equations.write(&self.values, states, row);
        }
        Ok(())
    }

    fn effort(&self) -> Effort {
        Effort { evaluations: self.equations.evaluations, steps: self.steps, rejections: 0 }
    }
}
