use super::deviation::angle;
use super::exact_motion::ExactMotion;
use crate::dynamics::Problem;
use crate::numerics::DoubleDouble;
use crate::propagation::{PreciseState, PropagationError, States, attitude_distance};
use crate::scenario::{Method, PlannedBody, ScenarioError, Setting};

/// The motion that errors are measured from.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// In principal axes.
    pub states: States,
    /// What made it.
    pub method: &'static str,
    /// What it was compared with.
    pub witness: &'static str,
    /// How far the witness is from it, rad: errors below this are not resolved.
    pub doubt_rad: f64,
}

/// The best motion known of `body` at `times`, s, and how far it can be trusted.
///
/// Taylor series in double-double, run twice by different steps: what is left in doubt is the rounding of the states to
/// f64. Where they do not reach (too many steps, or the digits of 106 bits are lost), the closed form with Taylor
/// series as the witness; or else Taylor series at their tightest with DOP853, when most of the doubt is the witness's
/// own error.
///
/// # Errors
/// If the motion ceases to be finite or a step cannot be made small enough.
pub fn reference_states(body: &PlannedBody, times: &[f64]) -> Result<Reference, ScenarioError> {
    let exact = exact_states(&body.problem, times, ExactMotion::MOST_STEPS)?;
    if exact.states.len() == times.len() { Ok(exact) } else { best_states(body, times) }
}

/// In double-double, at the first so many of the times: as far as the steps reach, or the digits of 106 bits.
pub(super) fn exact_states(problem: &Problem, times: &[f64], most_steps: u64) -> Result<Reference, PropagationError> {
    let exact = ExactMotion::at(problem, times.iter().copied(), most_steps)?;
    let (states, rounding) = rounded(&exact.states);
    let doubt_rad = exact.uncertainty + rounding;
    Ok(Reference { states, method: ExactMotion::NAME, witness: "the same by other steps", doubt_rad })
}

/// The best in f64 at all of the times, and another as the witness.
pub(super) fn best_states(body: &PlannedBody, times: &[f64]) -> Result<Reference, ScenarioError> {
    let is_known = tightest(body, Method::ClosedForm).is_ok();
    let (method, witness) =
        if is_known { (Method::ClosedForm, Method::Taylor) } else { (Method::Taylor, Method::Dop853) };
    let states = states(&tightest(body, method)?, times)?;
    let other = self::states(&tightest(body, witness)?, times)?;
    let doubt_rad = attitude_distance(&states, &other);
    Ok(Reference { states, method: method.key(), witness: witness.key(), doubt_rad })
}

/// Attitude and ω in f64, and how far that turns the attitude, rad.
pub(super) fn rounded(exact: &[PreciseState]) -> (States, f64) {
    let mut states = States::default();
    states.reset(exact.len(), true, false);
    for (row, state) in exact.iter().enumerate() {
        for (column, value) in states.attitude.iter_mut().zip(state.attitude) {
            column[row] = value.hi();
        }
        for (column, value) in states.angular_velocity.iter_mut().zip(state.angular_velocity) {
            column[row] = value.hi();
        }
    }
    let turned = exact.iter().enumerate().map(|(row, state)| angle(state.attitude, attitude(&states, row)));
    let turned = turned.fold(0.0, f64::max);
    (states, turned)
}

fn attitude(states: &States, row: usize) -> [DoubleDouble; 4] {
    states.attitude.each_ref().map(|column| DoubleDouble::from(column[row]))
}

/// `body` by `method` at full accuracy.
fn tightest(body: &PlannedBody, method: Method) -> Result<PlannedBody, ScenarioError> {
    debug_assert_ne!(method.setting(), Setting::Step, "a fixed step has no tightest");
    body.clone().by(method, None)
}

fn states(body: &PlannedBody, times: &[f64]) -> Result<States, ScenarioError> {
    let mut states = States::default();
    body.propagator()?.fill(times, &mut states)?;
    Ok(states)
}
