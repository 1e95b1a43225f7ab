use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::monodromy::{Monodromy, is_long};
use crate::body::{AngularVelocity, Attitude, State};
use crate::dynamics::Problem;
use crate::propagation::{PreciseState, PreciseTaylor, PropagationError, States, attitude_distances};
use crate::scenario::nudged;
use crate::study::reference::{Reference, rounded};

/// Patterns of roundings that are tried.
const PATTERNS: [u64; 3] = [0x5a5a_c3a5_9669_3c5a, 0x1234_5678_9abc_def0, 0xf0e1_d2c3_b4a5_9687];
/// Steps of a nudged run.
const MOST_STEPS: u64 = 20_000;

/// How far the motion has gone from the reference by each of the times if its numbers are off by a rounding; carried on in
/// proportion to time from where double-double gets to.
pub(super) fn conditions(
    problem: &Problem,
    reference: &Reference,
    times: &[f64],
) -> Result<Vec<f64>, PropagationError> {
    let mut conditions = vec![0.0_f64; times.len()];
    for pattern in PATTERNS {
        let (exact, reached) = nudged_motion(&nudged(problem, pattern), times)?;
        let nudged = rounded(&exact).0;
        let mut known = attitude_distances(&nudged, &reference.states);
        let mut moved = 0.0_f64;
        for (condition, time) in conditions.iter_mut().zip(times) {
            let here = known.next();
            moved = here.map_or(moved, |distance| distance.max(moved));
            let beyond = if here.is_none() && reached > 0.0 { time / reached } else { 1.0 };
            *condition = condition.max(moved * beyond);
        }
    }
    Ok(conditions)
}

/// Parts of the span at whose ends a state is rounded.
const ROUNDED: usize = 8;

/// How far a free body goes from the reference if its state is rounded to f64 once on the way.
pub(super) fn rounded_on_the_way(
    problem: &Problem,
    reference: &Reference,
    times: &[f64],
) -> Result<f64, PropagationError> {
    if !problem.loads.is_empty() || is_long(problem, times) {
        return Ok(0.0);
    }
    let mut most = 0.0_f64;
    for row in (1..ROUNDED).map(|part| part * times.len() / ROUNDED) {
        let from = |states: &States| {
            let [w, x, y, z] = states.attitude.each_ref().map(|column| column[row]);
            let attitude = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
            State {
                attitude: Attitude::from_world_from_body(attitude),
                angular_velocity: AngularVelocity::from_vector(Vector3::from(
                    states.angular_velocity.each_ref().map(|column| column[row]),
                )),
                ..problem.initial
            }
        };
        let restarted = Problem { initial: from(&reference.states), ..problem.clone() };
        let later: Vec<f64> = times[row..].iter().map(|time| time - times[row]).collect();
        let (exact, _) = nudged_motion(&restarted, &later)?;
        let rest = States {
            attitude: reference.states.attitude.each_ref().map(|column| column[row..].to_vec()),
            angular_velocity: reference.states.angular_velocity.each_ref().map(|column| column[row..].to_vec()),
            ..States::default()
        };
        most = attitude_distances(&rounded(&exact).0, &rest).fold(most, f64::max);
    }
    Ok(most)
}

/// At the first so many of the times, and how far that is, s.
fn nudged_motion(problem: &Problem, times: &[f64]) -> Result<(Vec<PreciseState>, f64), PropagationError> {
    if is_long(problem, times)
        && let Some(monodromy) = Monodromy::new(problem, PreciseTaylor::TOLERANCE)
        && let Some(states) = times.iter().map(|time| monodromy.at(*time)).collect::<Option<Vec<_>>>()
    {
        return Ok((states, times.last().copied().unwrap_or(0.0)));
    }
    let mut exact = PreciseTaylor::new(problem)?.limited_to(MOST_STEPS);
    let (mut states, mut reached) = (Vec::new(), 0.0);
    for time in times {
        let Some(state) = exact.at(*time)? else { break };
        reached = *time;
        states.push(state);
    }
    Ok((states, reached))
}
