use super::deviation::{angle, distance, length};
use crate::dynamics::Problem;
use crate::propagation::{PreciseState, PreciseTaylor, PropagationError};

/// Of the second run: other steps, so other rounding.
const OTHER_TOLERANCE: f64 = 1e-30;
/// How far the two runs may differ, rad and relative in ω: far below one rounding in f64.
const TRUSTED: f64 = 1e-18;

/// The motion in double-double at some times, as far as it reaches: run twice, by different steps.
pub(super) struct ExactMotion {
    /// At the first so many of the times.
    pub states: Vec<PreciseState>,
    /// How far that is, s.
    pub reached: f64,
    /// The largest difference between the two runs, rad or relative in ω.
    pub uncertainty: f64,
}

impl ExactMotion {
    /// As reports call it.
    pub const NAME: &str = "Taylor series in double-double";
    /// Steps at most, for each run: about a thousand turns.
    pub const MOST_STEPS: u64 = 20_000;

    /// At ascending times, s, as far as so many steps reach.
    pub fn at(problem: &Problem, times: impl Iterator<Item = f64>, most_steps: u64) -> Result<Self, PropagationError> {
        let mut reference = PreciseTaylor::new(problem)?.limited_to(most_steps);
        let mut other = reference.clone().with_tolerance(OTHER_TOLERANCE);
        let mut exact = Self { states: Vec::new(), reached: 0.0, uncertainty: 0.0 };
        let mut fastest = 0.0_f64;
        for time in times {
            let (Some(state), Some(again)) = (reference.at(time)?, other.at(time)?) else {
                exact.reached = reference.reached().min(other.reached());
                break;
            };
            fastest = length(state.angular_velocity).max(fastest);
            let apart = difference(&state, &again, fastest);
            if apart > TRUSTED {
                break;
            }
            exact.uncertainty = exact.uncertainty.max(apart);
            exact.reached = time;
            exact.states.push(state);
        }
        Ok(exact)
    }
}

/// Of attitudes in rad, or of ω relative to the fastest so far, as a body may come to rest; the larger.
fn difference(a: &PreciseState, b: &PreciseState, fastest: f64) -> f64 {
    let omega = distance(a.angular_velocity, b.angular_velocity);
    angle(a.attitude, b.attitude).max(if omega > 0.0 { omega / fastest } else { 0.0 })
}
