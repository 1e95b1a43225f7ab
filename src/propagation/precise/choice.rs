use super::propagator::PreciseBilinear;
use super::state::PreciseState;
use crate::dynamics::Problem;
use crate::numerics::DoubleDouble;
use crate::propagation::cloud::PreciseCloud;
use crate::propagation::general::PreciseGeneral;
use crate::propagation::sampling::check_times;
use crate::propagation::{Effort, PropagationError};

/// Motion under any loads to about 30 digits, by Taylor series in double-double: the measure of other propagators.
///
/// Every number of the problem is taken as the exact value of its f64; the first quaternion is normalised in
/// double-double. Steps end exactly on the edges of windows and on the knots of functions of time. Hundreds of times the
/// cost of [`Taylor`](super::super::Taylor).
#[derive(Debug, Clone)]
pub struct PreciseTaylor {
    way: Way,
    latest: f64,
    most_steps: u64,
}

#[derive(Debug, Clone)]
enum Way {
    ByHand(Box<PreciseBilinear>),
    ByTape(Box<PreciseGeneral>),
    OfParticles(Box<PreciseCloud>),
}

impl PreciseTaylor {
    /// Largest last terms of a series, relative, if nothing else is asked for.
    pub const TOLERANCE: f64 = 1e-32;

    /// At t = 0.
    ///
    /// # Errors
    /// [`PropagationError::NotCovered`] if a force moves a body of unknown mass, or two orbits act at once.
    pub fn new(problem: &Problem) -> Result<Self, PropagationError> {
        let way = if problem.cloud().is_some() {
            PreciseCloud::new(problem, Self::TOLERANCE).map(|way| Way::OfParticles(Box::new(way)))
        } else if problem.is_general() {
            PreciseGeneral::new(problem, Self::TOLERANCE).map(|way| Way::ByTape(Box::new(way)))
        } else {
            PreciseBilinear::new(problem).map(|way| Way::ByHand(Box::new(way)))
        };
        let way = way.map_err(|error| PropagationError::NotCovered { method: "precise Taylor", rule: error.rule() })?;
        Ok(Self { way, latest: 0.0, most_steps: u64::MAX })
    }

    /// The same, for at most so many steps: later times are then out of reach.
    #[must_use]
    pub fn limited_to(mut self, steps: u64) -> Self {
        self.most_steps = steps;
        self
    }

    /// The same by other steps, whose last terms may be as large as `tolerance`: what differs between two such runs
    /// tells how far either can be trusted.
    #[must_use]
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.way = match self.way {
            Way::ByHand(way) => Way::ByHand(Box::new(way.with_tolerance(tolerance))),
            Way::ByTape(way) => Way::ByTape(Box::new(way.with_tolerance(tolerance))),
            Way::OfParticles(way) => Way::OfParticles(Box::new(way.with_tolerance(tolerance))),
        };
        self
    }

    /// The state at `time`, s, not before that of the last call; `None` if the limit of steps does not reach so far.
    ///
    /// # Errors
    /// If the time goes back, the state ceases to be finite, or a step cannot be made small enough.
    pub fn at(&mut self, time: f64) -> Result<Option<PreciseState>, PropagationError> {
        self.at_exactly(DoubleDouble::from(time))
    }

    /// The same at an instant between two f64.
    ///
    /// # Errors
    /// As for [`Self::at`].
    pub fn at_exactly(&mut self, wanted: DoubleDouble) -> Result<Option<PreciseState>, PropagationError> {
        check_times(&[wanted.hi()], self.latest)?;
        while self.end() < wanted {
            if self.effort().steps >= self.most_steps {
                return Ok(None);
            }
            match &mut self.way {
                Way::ByHand(way) => way.advance()?,
                Way::ByTape(way) => way.advance()?,
                Way::OfParticles(way) => way.advance()?,
            }
        }
        self.latest = wanted.hi();
        Ok(Some(match &self.way {
            Way::ByHand(way) => way.within(wanted),
            Way::ByTape(way) => way.within(wanted),
            Way::OfParticles(way) => way.within(wanted)?,
        }))
    }

    /// How far it has come, s.
    #[must_use]
    pub fn reached(&self) -> f64 {
        self.end().hi()
    }

    /// Evaluations and steps so far.
    #[must_use]
    pub fn effort(&self) -> Effort {
        match &self.way {
            Way::ByHand(way) => way.effort(),
            Way::ByTape(way) => way.effort(),
            Way::OfParticles(way) => way.effort(),
        }
    }

    fn end(&self) -> DoubleDouble {
        match &self.way {
            Way::ByHand(way) => way.end(),
            Way::ByTape(way) => way.end(),
            Way::OfParticles(way) => way.end(),
        }
    }
}
