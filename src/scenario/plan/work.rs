//! Whether a run can come to its end: asked before it is started.

use super::path::{closed_form, fixed_step};
use crate::dynamics::{Problem, Schedule, Torque};
use crate::propagation::Taylor;
use crate::scenario::{Key, Method, Refusal, Scenario};

/// Steps of a run at most: hours.
const MOST_STEPS: f64 = 1e11;
/// Turns of a run at most: later, 106 bits of phase no longer hold the attitude to 1e-15 rad.
const MOST_TURNS: f64 = 1e15;
/// Steps that are tried.
const TRIED: u64 = 2000;
/// Spans that are tried: a table of many knots is looked at from its beginning.
const MOST_SPANS: usize = 1000;
/// Of a step of the trial, rad: how many there are hardly depends on it.
const TOLERANCE: f64 = 1e-6;

/// Refuses what would take more than 1e11 steps or 1e15 turns, or cannot be stepped at all, until `end`, s.
pub fn check(scenario: &Scenario, problem: &Problem, moves: bool, end: f64) -> Result<(), Refusal> {
    if fixed_step(scenario.method).is_some() {
        // Whether there is a step, and whether it is positive, is asked elsewhere.
        return scenario.step_s.filter(|step| *step > 0.0).map_or(Ok(()), |step| {
            let rule = || format!("{step:?} s makes {:.1e} steps in {end:?} s: at most {MOST_STEPS:e}", end / step);
            if end / step > MOST_STEPS { Err(Key::root("step_s").refuse(rule())) } else { Ok(()) }
        });
    }
    let is_exact =
        matches!(scenario.method, Method::Auto | Method::ClosedForm) && closed_form(problem, moves).is_some();
    let key = Key::root(if scenario.duration_s.is_some() { "duration_s" } else { "sample_times_s" });
    if is_exact { turns(&key, problem, end) } else { steps(&key, problem, end) }
}

/// Of a closed form.
fn turns(key: &Key, problem: &Problem, end: f64) -> Result<(), Refusal> {
    let speeding = |torque: &Torque| match torque {
        Torque::ConstantBody { moment } => moment.norm() / problem.moments.vector().min(),
        _ => 0.0,
    };
    let gained: f64 = problem.loads.iter().map(|load| speeding(&load.torque)).sum();
    let turns = (problem.initial.angular_velocity.in_body().norm() + 0.5 * gained * end) * end / std::f64::consts::TAU;
    // Written so that NaN is refused too.
    if turns <= MOST_TURNS {
        return Ok(());
    }
    let rule = format!("{end:?} s make {turns:.1e} turns: at most {MOST_TURNS:e}, as more leave no phase to be told");
    Err(key.refuse(rule))
}

/// Of a stepper: a short trial of each span, no longer than its steps allow, whatever comes later.
fn steps(key: &Key, problem: &Problem, end: f64) -> Result<(), Refusal> {
    let refuse = |what: &dyn std::fmt::Display| key.refuse(format_args!("{end:?} s cannot be propagated: {what}"));
    let schedule = Schedule::new(problem).map_err(|error| refuse(&error))?;
    let mut trial = Taylor::new(problem, TOLERANCE).map_err(|error| refuse(&error))?;
    let bounds = (0..schedule.count().min(MOST_SPANS)).map(|index| schedule.bounds(index));
    for (start, span_end) in bounds.filter(|(start, _)| *start < end) {
        let target = span_end.min(end);
        let half_way = trial.reach(target, TRIED / 2).map_err(|error| refuse(&error))?;
        let reached = trial.reach(target, TRIED / 2).map_err(|error| refuse(&error))?;
        if reached < target {
            // A span may begin slowly.
            let mean = (reached - half_way) / count(TRIED / 2);
            let wanted = (end - start) / mean;
            if wanted > MOST_STEPS {
                let rule = format!("steps of {mean:.1e} s, {wanted:.1e} of them: at most {MOST_STEPS:e}");
                return Err(refuse(&rule));
            }
            return Ok(());
        }
    }
    Ok(())
}

#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
fn count(steps: u64) -> f64 {
    steps as f64
}
