use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::monodromy::Monodromy;
use crate::body::{AngularVelocity, Attitude, State};
use crate::dynamics::Problem;
use crate::propagation::{PreciseState, PreciseTaylor, PropagationError, States, attitude_distances};
use crate::scenario::{Path, PlannedBody, ScenarioError, nudged};
use crate::study::deviation::angle;
use crate::study::reference::{Reference, reference_states, rounded};

/// What errors of one case are measured from, and how large they may be.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// The motion, and in how much doubt it is.
    pub reference: Reference,
    /// The condition: how far the true motion moves within the span if every number of its start and of its loads is off
    /// by about one rounding, rad: of three patterns of roundings, the worst. Of a free body that does not turn for long,
    /// its states on the way are rounded, too: near the middle axis that moves it by far more.
    pub condition_rad: f64,
    /// The largest rate at any of the times, rad/s.
    pub fastest: f64,
    /// When states are compared, s.
    pub times_s: Vec<f64>,
}

/// Patterns of roundings that are tried.
const PATTERNS: [u64; 3] = [0x5a5a_c3a5_9669_3c5a, 0x1234_5678_9abc_def0, 0xf0e1_d2c3_b4a5_9687];
/// Turns after which one period and its powers are the cheaper reference.
const LONG: f64 = 500.0;
/// Steps of a nudged run.
const MOST_STEPS: u64 = 20_000;
/// Of the monodromy's witness.
const OTHER_TOLERANCE: f64 = 1e-30;
/// The two references may differ by this much, rad.
const TRUSTED: f64 = 1e-16;

impl Truth {
    /// What a closed form may be off at any time, rad: twice `ATTITUDE_LIMIT_RAD` of the oracle's tests, as the reference
    /// is rounded to f64 too.
    pub const EXACT_RAD: f64 = 2e-15;
    /// What the roundings of n steps may add up to: this times the condition times √n.
    pub const ROUNDINGS: f64 = 2.0;

    /// Of `body` at `times_s`.
    ///
    /// # Errors
    /// If no reference can be had.
    pub fn of(body: &PlannedBody, times_s: Vec<f64>) -> Result<Self, ScenarioError> {
        let reference = match long_reference(&body.problem, &times_s) {
            Some(reference) => reference,
            None => reference_states(body, &times_s)?,
        };
        let omega = &reference.states.angular_velocity;
        let rate = |row: usize| libm::hypot(libm::hypot(omega[0][row], omega[1][row]), omega[2][row]);
        let fastest = (0..reference.states.len()).map(rate).fold(0.0, f64::max);
        let condition_rad = condition(&body.problem, &reference, &times_s)?.max(rounded_on_the_way(
            &body.problem,
            &reference,
            &times_s,
        )?);
        Ok(Self { reference, condition_rad, fastest, times_s })
    }

    /// What a run at full accuracy by `path` may be off, rad.
    ///
    /// A closed form: 2e-15, whatever the condition, as it is right for the numbers that it is given. A stepper rounds its
    /// state at each of its n steps, and the motion magnifies that as it does roundings of the start: 2e-15 + 2 κ √n, with
    /// the condition κ. What the reference does not resolve is allowed in either case.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a bound")]
    pub fn limit_rad(&self, path: Path, steps: u64) -> f64 {
        let rounding = match path {
            Path::Taylor { .. } | Path::Dop853 { .. } | Path::FixedStep { .. } => {
                Self::ROUNDINGS * self.condition_rad * (steps as f64).sqrt()
            }
            Path::ClosedForm | Path::LagrangeTop | Path::MomentumBrake | Path::AxialTorque => 0.0,
        };
        Self::EXACT_RAD + rounding + self.reference.doubt_rad
    }
}

/// Of a free body over many turns, if its period can be had.
fn long_reference(problem: &Problem, times: &[f64]) -> Option<Reference> {
    if !is_long(problem, times) {
        return None;
    }
    let states = |tolerance: f64| -> Option<Vec<PreciseState>> {
        let monodromy = Monodromy::new(problem, tolerance)?;
        times.iter().map(|time| monodromy.at(*time)).collect()
    };
    let (exact, other) = (states(PreciseTaylor::TOLERANCE)?, states(OTHER_TOLERANCE)?);
    let apart = exact.iter().zip(&other).map(|(a, b)| angle(a.attitude, b.attitude)).fold(0.0, f64::max);
    let (states, rounding) = rounded(&exact);
    let witness = "the same by other steps";
    (apart <= TRUSTED).then_some(Reference { states, method: Monodromy::NAME, witness, doubt_rad: apart + rounding })
}

fn is_long(problem: &Problem, times: &[f64]) -> bool {
    let turns = problem.initial.angular_velocity.in_body().norm() * times.last().copied().unwrap_or(0.0);
    problem.loads.is_empty() && turns > LONG * std::f64::consts::TAU
}

/// How far the motion goes from the reference if its numbers are off by a rounding; carried on in proportion to time from
/// where double-double gets to.
fn condition(problem: &Problem, reference: &Reference, times: &[f64]) -> Result<f64, PropagationError> {
    let mut most = 0.0_f64;
    for pattern in PATTERNS {
        let (exact, reached) = nudged_motion(&nudged(problem, pattern), times)?;
        let moved = attitude_distances(&rounded(&exact).0, &reference.states).fold(0.0, f64::max);
        let beyond = times.last().map_or(1.0, |end| if reached > 0.0 { end / reached } else { 1.0 });
        most = most.max(moved * beyond);
    }
    Ok(most)
}

/// Parts of the span at whose ends a state is rounded.
const ROUNDED: usize = 8;

/// How far a free body goes from the reference if its state is rounded to f64 once on the way.
fn rounded_on_the_way(problem: &Problem, reference: &Reference, times: &[f64]) -> Result<f64, PropagationError> {
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
