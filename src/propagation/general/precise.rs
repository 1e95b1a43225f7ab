use super::motion::Motion;
use super::stepper::Stepper;
use crate::dynamics::{DynamicsError, Problem};
use crate::numerics::DoubleDouble;
use crate::propagation::{Effort, PreciseState, PropagationError};

/// Taylor series in double-double of a tape: the very operations of the run in f64, in twice its digits.
#[derive(Debug, Clone)]
pub(in crate::propagation) struct PreciseGeneral(Stepper<DoubleDouble>);

impl PreciseGeneral {
    /// About that at which a step is cheapest for its length, −½ ln tolerance + 1 `[JZ05]` §3.
    const ORDER: usize = 36;

    pub fn new(problem: &Problem, tolerance: f64) -> Result<Self, DynamicsError> {
        Stepper::new(problem, Self::ORDER, tolerance).map(Self)
    }

    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self(self.0.with_tolerance(tolerance))
    }

    /// Makes one step.
    pub fn advance(&mut self) -> Result<(), PropagationError> {
        self.0.advance()
    }

    /// The state at a time within the last step, s.
    pub fn within(&self, time: DoubleDouble) -> PreciseState {
        let motion: Motion = self.0.at(time);
        PreciseState {
            attitude: motion.attitude(),
            angular_velocity: motion.rates(),
            position: motion.position(),
            velocity: motion.velocity(),
        }
    }

    pub fn end(&self) -> DoubleDouble {
        self.0.end()
    }

    pub fn effort(&self) -> Effort {
        self.0.effort()
    }
}
