use super::fit::rates;
use super::stepper::{Exactness, Stepper};
use crate::dynamics::{DynamicsError, Problem};
use crate::numerics::DoubleDouble;
use crate::propagation::{Effort, PreciseState, PropagationError};

/// Taylor series in double-double of every particle: the very operations of the run in f64, in twice its digits.
#[derive(Debug, Clone)]
pub(in crate::propagation) struct PreciseCloud {
    stepper: Stepper<DoubleDouble>,
    problem: Problem,
}

impl PreciseCloud {
    /// About that at which a step is cheapest for its length, −½ ln tolerance + 1 `[JZ05]` §3.
    const ORDER: usize = 36;

    pub fn new(problem: &Problem, tolerance: f64) -> Result<Self, DynamicsError> {
        let exactness = Exactness { order: Self::ORDER, tolerance, enough: 1e-17 };
        Ok(Self { stepper: Stepper::new(problem, exactness)?, problem: problem.clone() })
    }

    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { stepper: self.stepper.with_tolerance(tolerance), ..self }
    }

    /// Makes one step.
    pub fn advance(&mut self) -> Result<(), PropagationError> {
        self.stepper.advance()
    }

    /// The state at a time within the last step, s: that of the cloud as a whole.
    pub fn within(&self, time: DoubleDouble) -> Result<PreciseState, PropagationError> {
        let (motion, attitude) = self.stepper.at(time)?;
        let fall = |axis: usize| {
            let initial = &self.problem.initial;
            let pull = time * self.problem.gravity[axis];
            let speed = DoubleDouble::from(initial.velocity[axis]);
            let place = DoubleDouble::from(initial.position[axis]) + time * (speed + pull.scale(0.5));
            (place, speed + pull)
        };
        Ok(PreciseState {
            attitude,
            angular_velocity: rates(&self.stepper.springs, &motion, attitude),
            position: [0, 1, 2].map(|axis| fall(axis).0),
            velocity: [0, 1, 2].map(|axis| fall(axis).1),
        })
    }

    pub fn end(&self) -> DoubleDouble {
        self.stepper.end()
    }

    pub fn effort(&self) -> Effort {
        self.stepper.effort()
    }
}
