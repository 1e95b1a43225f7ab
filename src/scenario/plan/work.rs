//! Whether a run can come to its end: asked before it is started.

use super::path::{closed_form, fixed_step};
use crate::dynamics::{Problem, Schedule, Torque};
use crate::propagation::{Propagator, States, Taylor};
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
/// The exponent of the smallest number.
const DEEPEST: i32 = 1074;

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

/// Of a stepper: a short trial of each span, at times that double, as the number of steps then grows by small factors
/// from one to the next, however fast the body is driven.
fn steps(key: &Key, problem: &Problem, end: f64) -> Result<(), Refusal> {
    let refuse = |what: &dyn std::fmt::Display| key.refuse(format_args!("{end:?} s cannot be propagated: {what}"));
    let schedule = Schedule::new(problem).map_err(|error| refuse(&error))?;
    let mut trial = Taylor::new(problem, TOLERANCE).map_err(|error| refuse(&error))?;
    let mut states = States::default();
    let bounds = (0..schedule.count().min(MOST_SPANS)).map(|index| schedule.bounds(index));
    for (start, span_end) in bounds.filter(|(start, _)| *start < end) {
        let length = span_end.min(end) - start;
        let before = trial.effort().steps;
        // Later, time itself is no finer than this.
        let halvings = if start > 0.0 { exponent(length / start) + 52 } else { DEEPEST };
        for halvings in (0..=halvings.max(0)).rev() {
            let passed = libm::ldexp(length, -halvings);
            trial.fill(&[start + passed], &mut states).map_err(|error| refuse(&error))?;
            let made = trial.effort().steps - before;
            if made > TRIED {
                let mean = passed / count(made);
                let wanted = (end - start) / mean;
                if wanted > MOST_STEPS {
                    let rule = format!("steps of {mean:.1e} s, {wanted:.1e} of them: at most {MOST_STEPS:e}");
                    return Err(refuse(&rule));
                }
                return Ok(());
            }
        }
    }
    Ok(())
}

/// Of two in a positive number, about.
fn exponent(value: f64) -> i32 {
    if value > 0.0 && value.is_finite() { libm::ilogb(value) } else { 0 }
}

#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
fn count(steps: u64) -> f64 {
    steps as f64
}
