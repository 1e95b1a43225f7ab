use super::equal_steps::EqualSteps;
use super::{Coverage, FixedStepMethod, Scheme};
use crate::dynamics::{Problem, TorqueModel};
use crate::propagation::equations::{ATTITUDE, Equations, Values, normalise};
use crate::propagation::sampling::check_times;
use crate::propagation::{Effort, PropagationError, Propagator, States};

/// A method with a fixed step.
///
/// From one sample time or window edge to the next it takes a whole number of equal steps, none longer than asked for,
/// so that it lands on all of them.
pub struct FixedStep {
    equations: Equations,
    scheme: Box<dyn Scheme>,
    /// s.
    longest_step: f64,
    time: f64,
    values: Values,
    /// Evaluations are counted by the equations.
    effort: Effort,
}

impl FixedStep {
    /// From a problem, a method and its longest step, s.
    ///
    /// # Errors
    /// [`PropagationError::NotCovered`] if the step is not positive and finite, the method's [`Coverage`] leaves the
    /// problem out, a force moves a body of unknown mass, or two orbits act at once.
    pub fn new(problem: &Problem, method: FixedStepMethod, longest_step: f64) -> Result<Self, PropagationError> {
        Self::build(problem, None, method, longest_step)
    }

    /// The same with a moment of the caller's own beside the problem's loads.
    ///
    /// # Errors
    /// As for [`Self::new`], and if the method's coverage is not [`Coverage::Everything`].
    pub fn with_model(
        problem: &Problem,
        model: Box<dyn TorqueModel + Send>,
        method: FixedStepMethod,
        longest_step: f64,
    ) -> Result<Self, PropagationError> {
        Self::build(problem, Some(model), method, longest_step)
    }

    fn build(
        problem: &Problem,
        model: Option<Box<dyn TorqueModel + Send>>,
        method: FixedStepMethod,
        longest_step: f64,
    ) -> Result<Self, PropagationError> {
        let not_covered = |rule| PropagationError::NotCovered { method: method.information().title, rule };
        if !(longest_step > 0.0 && longest_step < f64::INFINITY) {
            return Err(not_covered("its step must be positive and finite"));
        }
        match method.information().coverage {
            Coverage::TorqueFree if !problem.loads.is_empty() || model.is_some() => {
                return Err(not_covered("nothing may act on the body"));
            }
            Coverage::ListedLoads if problem.has_rotor() => {
                return Err(not_covered("it knows no flow of a body that carries a rotor"));
            }
            Coverage::ListedLoads if model.is_some() || problem.is_general() => {
                return Err(not_covered("it knows the flow of constants, couples, damping and functions of time only"));
            }
            _ => {}
        }
        let equations = Equations::new(problem, model).map_err(|error| not_covered(error.rule()))?;
        let values = equations.initial();
        Ok(Self {
            equations,
            scheme: method.scheme(problem),
            longest_step,
            time: 0.0,
            values,
            effort: Effort::default(),
        })
    }

    /// Steps to `end`, within the current span.
    fn step_to(&mut self, end: f64) -> Result<(), PropagationError> {
        if end <= self.time {
            return Ok(());
        }
        let steps = EqualSteps::new(self.time, end, self.longest_step)?;
        let length = steps.length;
        for time in steps {
            self.time = time;
            let values = self.scheme.step(&mut self.equations, time, length, &self.values)?;
            // A run that explodes may overflow in |q| alone, and leave a quaternion of no length.
            if values.iter().any(|value| !value.is_finite()) || !(0.25..4.0).contains(&square_of_length(&values)) {
                return Err(PropagationError::NotFinite { time });
            }
            self.values = values;
            self.effort.include_step(length);
        }
        self.time = end;
        Ok(())
    }
}

/// What |q|² may differ from 1 by rounding.
const ROUNDING: f64 = 1e-15;

/// With q of unit length: Gauss's methods carry its length unforced, which wanders by a rounding a step.
fn unit(mut values: Values) -> Values {
    if (square_of_length(&values) - 1.0).abs() > ROUNDING {
        normalise(&mut values);
    }
    values
}

/// |q|².
fn square_of_length(values: &Values) -> f64 {
    values[ATTITUDE].iter().map(|component| component * component).sum()
}

impl Propagator for FixedStep {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.time)?;
        self.equations.reset(states, times.len());
        for (row, &time) in times.iter().enumerate() {
            while time > self.equations.span().end {
                self.step_to(self.equations.span().end)?;
                self.equations.next_span();
            }
            self.step_to(time)?;
            self.equations.write(&unit(self.values), states, row);
        }
        Ok(())
    }

    fn effort(&self) -> Effort {
        Effort { evaluations: self.equations.evaluations, ..self.effort }
    }
}
