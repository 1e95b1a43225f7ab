use super::trials::{Trial, Trials};
use crate::dynamics::Problem;
use crate::propagation::{Dop853, PropagationError, Propagator, Taylor};
use crate::scenario::Path;

/// The loosest tolerance of a step that is tried, rad.
const LOOSEST: f64 = 0.1;
/// Trials of one stepper at most.
const MOST_TRIALS: u32 = 12;
/// A tolerance is loose enough if the error is no less than this part of what is allowed.
const NEAR: f64 = 1.0 / 16.0;
/// The part of the error allowed that the next trial aims at.
const AIM: f64 = 0.25;
/// A trial whose error is this far from the aim, or more, says no more than the direction.
const FARTHEST: f64 = 1e-4;

/// A method that is told the error of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stepper {
    Taylor,
    Dop853,
}

impl Stepper {
    /// As tight as f64 carries; for DOP853, the least that its error estimate can tell.
    pub const fn tightest(self) -> f64 {
        match self {
            Self::Taylor => 1e-16,
            Self::Dop853 => 1e-15,
        }
    }

    /// The path with a tolerance for each step, rad, or its tightest where that is less.
    pub const fn path(self, tolerance: f64) -> Path {
        let tolerance = tolerance.max(self.tightest());
        match self {
            Self::Taylor => Path::Taylor { tolerance },
            Self::Dop853 => Path::Dop853 { tolerance },
        }
    }

    pub fn start(self, problem: &Problem, tolerance: f64) -> Result<Box<dyn Propagator>, PropagationError> {
        Ok(match self {
            Self::Taylor => Box::new(Taylor::new(problem, tolerance)?),
            Self::Dop853 => Box::new(Dop853::new(problem, tolerance)?),
        })
    }
}

/// A tolerance and what it led to.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    pub stepper: Stepper,
    /// Of a step, rad.
    pub tolerance: f64,
    pub trial: Trial,
}

/// The loosest tolerance, within a factor, whose error is at most half of what the floor leaves of the promise: the
/// other half is for instants between the samples and for what the trials' own reference lacks.
///
/// Errors go like the tolerance, so that each trial says where the next should be.
pub fn search(trials: &Trials, stepper: Stepper, promise: f64) -> Option<Candidate> {
    let allowed = 0.5 * (promise - trials.floor());
    let tightest = stepper.tightest();
    // No step may be farther off than the run: where nothing turns, the attitude tells nothing of the way.
    let loosest = promise.clamp(tightest, LOOSEST);
    let mut tolerance = loosest;
    let (mut best, mut too_loose): (Option<Candidate>, f64) = (None, f64::INFINITY);
    for _ in 0..MOST_TRIALS {
        let trial = trials.by(stepper, tolerance);
        let error = trial.map_or(f64::INFINITY, |trial| trial.error);
        let step = (AIM * allowed / error.max(f64::MIN_POSITIVE)).clamp(FARTHEST, 1.0 / FARTHEST);
        match trial {
            Some(trial) if error <= allowed => {
                best = Some(Candidate { stepper, tolerance, trial });
                if error >= NEAR * allowed || tolerance >= loosest {
                    break;
                }
            }
            _ if tolerance <= tightest => break,
            _ => too_loose = tolerance,
        }
        let next = (tolerance * step).clamp(tightest, loosest);
        let kept = best.map_or(0.0, |best| best.tolerance);
        // Between what keeps it and what does not, once both are known.
        let next = if next >= too_loose || next <= kept { (kept * too_loose).sqrt() } else { next };
        if best.is_some() && too_loose < 2.0 * kept {
            break;
        }
        tolerance = next;
    }
    best
}
