use super::condition::{conditions, rounded_on_the_way};
use super::monodromy::{Monodromy, is_long};
use crate::dynamics::Problem;
use crate::propagation::{PreciseState, PreciseTaylor, States};
use crate::scenario::{Path, PlannedBody, ScenarioError};
use crate::study::deviation::angle;
use crate::study::reference::{Reference, best_states, exact_states, rounded};

/// What errors of one case are measured from, and how large they may be.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// The motion, and in how much doubt it is; at the times up to the horizon.
    pub reference: Reference,
    /// The last time at which anything can be asked of an attitude, s, where it comes before the end: later the condition
    /// is beyond [`Truth::HORIZON_RAD`]. Runs go on, and must stay sound.
    pub horizon_s: Option<f64>,
    /// The condition: how far the true motion moves up to the horizon if every number of its start and of its loads is off
    /// by about one rounding, rad: of three patterns of roundings, the worst. Of a free body that does not turn for long,
    /// its states on the way are rounded, too: near the middle axis that moves it by far more.
    pub condition_rad: f64,
    /// The largest rate at any of the times, rad/s.
    pub fastest: f64,
    /// When states are looked at, s.
    pub times_s: Vec<f64>,
}

/// Steps of a reference.
const MOST_EXACT_STEPS: u64 = 200_000;
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

    /// The condition up to which attitudes are judged: within it, roundings of 250,000 steps make [`Trial::LOST_RAD`].
    ///
    /// [`Trial::LOST_RAD`]: super::Trial::LOST_RAD
    pub const HORIZON_RAD: f64 = 1e-4;

    /// Of `body` at `times_s`.
    ///
    /// # Errors
    /// If no reference can be had.
    pub fn of(body: &PlannedBody, times_s: Vec<f64>) -> Result<Self, ScenarioError> {
        let problem = &body.problem;
        let long = long_reference(problem, &times_s);
        let is_periodic = long.is_some();
        let mut reference = match long {
            Some(reference) => reference,
            None => short_reference(body, &times_s)?,
        };
        let conditions = conditions(problem, &reference, &times_s[..reference.states.len()])?;
        // The first time is the start, where nothing has moved. Motion by its period is known however late, and closed forms
        // are right for the numbers that they are given.
        let told = conditions.iter().take_while(|moved| **moved <= Self::HORIZON_RAD).count().max(1);
        let judged = if is_periodic { times_s.len() } else { told };
        cut(&mut reference.states, judged);
        let horizon_s = times_s.get(judged - 1).copied().filter(|_| judged < times_s.len());
        let omega = &reference.states.angular_velocity;
        let rate = |row: usize| libm::hypot(libm::hypot(omega[0][row], omega[1][row]), omega[2][row]);
        let fastest = (0..judged).map(rate).fold(0.0, f64::max);
        let on_the_way = rounded_on_the_way(problem, &reference, &times_s[..judged])?;
        let condition_rad = conditions.get(judged - 1).copied().unwrap_or(0.0).max(on_the_way);
        Ok(Self { reference, horizon_s, condition_rad, fastest, times_s })
    }

    /// A turn of the fastest rate, s; or the whole span, if it is no radian.
    #[must_use]
    pub fn turn_s(&self) -> f64 {
        let span = self.times_s.last().copied().unwrap_or(0.0);
        if self.fastest * span > 1.0 { std::f64::consts::TAU / self.fastest } else { span }
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

/// In double-double, as far as that can be had; all of the times in f64 only where that leaves less in doubt than a chaotic
/// motion does.
fn short_reference(body: &PlannedBody, times: &[f64]) -> Result<Reference, ScenarioError> {
    let exact = exact_states(&body.problem, times, MOST_EXACT_STEPS)?;
    if exact.states.len() == times.len() {
        return Ok(exact);
    }
    let best = best_states(body, times)?;
    Ok(if best.doubt_rad <= Truth::HORIZON_RAD || exact.states.len() < 2 { best } else { exact })
}

fn cut(states: &mut States, rows: usize) {
    states.attitude.iter_mut().chain(&mut states.angular_velocity).for_each(|column| column.truncate(rows));
}
