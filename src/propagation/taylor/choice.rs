use super::propagator::Bilinear;
use super::step_size::order_for;
use crate::dynamics::Problem;
use crate::propagation::cloud::CloudTaylor;
use crate::propagation::general::GeneralTaylor;
use crate::propagation::{Effort, PropagationError, Propagator, States};

/// Motion under any loads, by Taylor series of high order with dense output `[JZ05]`.
///
/// The state is carried with more digits than f64, steps stop exactly where a load starts or ends and where a function
/// of time has a knot, and no step is ever thrown away: its length follows from the series. Where the steps lie does not
/// depend on the sample times. Loads of a [`General`](crate::dynamics::General) kind go by a tape of operations, all others
/// by recurrences laid out by hand. Of a body that is a [`SpringCloud`](crate::dynamics::SpringCloud) every particle is
/// followed: the attitude is that of the best fit, and ω is its rate.
#[derive(Debug, Clone)]
pub struct Taylor {
    way: Way,
    /// Why it cannot go on: what is left of the step that failed tells nothing.
    failure: Option<PropagationError>,
}

#[derive(Debug, Clone)]
enum Way {
    ByHand(Box<Bilinear>),
    ByTape(Box<GeneralTaylor>),
    OfParticles(Box<CloudTaylor>),
}

impl Taylor {
    /// From a problem and the error allowed per step: rad of attitude, and relative in the rates.
    ///
    /// The order follows from `tolerance`, up to 24; below 1e-17 nothing is gained.
    ///
    /// # Errors
    /// [`PropagationError::NotCovered`] if the tolerance is not between 0 and 1, a force moves a body of unknown mass,
    /// or two orbits act at once.
    pub fn new(problem: &Problem, tolerance: f64) -> Result<Self, PropagationError> {
        let not_covered = |rule| PropagationError::NotCovered { method: "Taylor", rule };
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(not_covered("its tolerance must lie between 0 and 1"));
        }
        let way = if problem.cloud().is_some() {
            CloudTaylor::new(problem, order_for(tolerance), tolerance).map(|way| Way::OfParticles(Box::new(way)))
        } else if problem.is_general() {
            GeneralTaylor::new(problem, order_for(tolerance), tolerance).map(|way| Way::ByTape(Box::new(way)))
        } else {
            Bilinear::new(problem, tolerance).map(|way| Way::ByHand(Box::new(way)))
        };
        way.map(|way| Self { way, failure: None }).map_err(|error| not_covered(error.rule()))
    }

    /// The order of its series.
    #[must_use]
    pub fn order(&self) -> usize {
        match &self.way {
            Way::ByHand(way) => way.order(),
            Way::ByTape(way) => way.order(),
            Way::OfParticles(way) => way.order(),
        }
    }

    /// Goes on towards `time`, s, by so many steps at most; how far it has come, s. Earlier times are then past.
    ///
    /// # Errors
    /// If the state ceases to be finite or a step cannot be made small enough.
    pub fn reach(&mut self, time: f64, steps: u64) -> Result<f64, PropagationError> {
        self.unless_failed(|way| match way {
            Way::ByHand(way) => way.reach(time, steps),
            Way::ByTape(way) => way.reach(time, steps),
            Way::OfParticles(way) => way.reach(time, steps),
        })
    }

    /// An error stays one, whatever is asked next.
    fn unless_failed<T>(
        &mut self,
        go_on: impl FnOnce(&mut Way) -> Result<T, PropagationError>,
    ) -> Result<T, PropagationError> {
        if let Some(failure) = &self.failure {
            return Err(failure.clone());
        }
        let result = go_on(&mut self.way);
        // A time that goes back is the caller's mistake, and nothing is lost by it.
        self.failure =
            result.as_ref().err().filter(|error| !matches!(error, PropagationError::NotAscending { .. })).cloned();
        result
    }
}

impl Propagator for Taylor {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        self.unless_failed(|way| match way {
            Way::ByHand(way) => way.fill(times, states),
            Way::ByTape(way) => way.fill(times, states),
            Way::OfParticles(way) => way.fill(times, states),
        })
    }

    fn effort(&self) -> Effort {
        match &self.way {
            Way::ByHand(way) => way.effort(),
            Way::ByTape(way) => way.effort(),
            Way::OfParticles(way) => way.effort(),
        }
    }
}
