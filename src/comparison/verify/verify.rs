use thiserror::Error;

use super::candidates::FEWEST_PER_TURN;
use super::laws::{MOST_INTERVALS, Steps};
use super::pushed::Pushed;
use super::series::Series;
use super::subject::Subject;
use super::{
    Candidates, Clock, Distance, InertiaFit, Kinematics, Laws, Length, Montgomery, Reading, Verdict, Verification,
    hypotheses, judge,
};
use crate::propagation::PropagationError;
use crate::recording::{Axes, Observed};
use crate::scenario::{PlannedBody, ScenarioError};

/// Why a file's rotation cannot be looked at.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// Neither attitudes nor rates that can be read.
    #[error("{name}: it has neither attitudes nor angular velocities that can be read")]
    NothingTurns {
        /// The body.
        name: String,
    },
    /// Too few samples.
    #[error("{name}: {samples} samples are too few: it takes {FEWEST_SAMPLES}")]
    TooFew {
        /// The body.
        name: String,
        /// Those that can be used.
        samples: usize,
    },
    /// The exact motion cannot be worked out.
    #[error("the exact motion: {0}")]
    Propagation(#[from] PropagationError),
    /// The same.
    #[error("the exact motion: {0}")]
    Scenario(#[from] ScenarioError),
}

/// Samples needed to say anything.
pub const FEWEST_SAMPLES: usize = 8;
/// How far an attitude may be from the exact motion unless told otherwise, rad.
pub const DEFAULT_TOLERANCE_RAD: f64 = 1e-3;

/// Holds what a file says of a body's rotation against physics.
///
/// Without a body only what attitude and ω say of each other is judged. With one, whose problem's first state is not
/// looked at, ω, L and E are held to its torques from sample to sample, and attitudes to the exact motion through the
/// first state, within `tolerance_rad`. Of a body on which nothing acts, the moment that the file records is taken to act.
/// A body under a [`General`](crate::dynamics::General) load is judged as if none were given, and a remark says so.
/// `time_resolution_s` is half a unit in the last place of the file's times.
///
/// # Errors
/// If there is too little to look at, or the exact motion cannot be worked out.
pub fn verify(
    observed: &Observed,
    body: Option<&PlannedBody>,
    time_resolution_s: f64,
    tolerance_rad: f64,
) -> Result<Verification, VerifyError> {
    // A formula of time, an anchor in the world, a sphere that turns by itself: no sample says all that is needed to go on.
    let is_general = body.is_some_and(|body| body.problem.is_general());
    let body = body.filter(|_| !is_general);
    let (clock, used) = Clock::of(observed, time_resolution_s);
    let name = || observed.name.clone();
    let length = Length::of(observed);
    if used.len() < FEWEST_SAMPLES {
        // A frozen attitude is no attitude: but its rates may be read.
        return Err(VerifyError::TooFew { name: name(), samples: used.len() });
    }
    let candidates = Candidates::of(observed, &used).ok_or_else(|| VerifyError::NothingTurns { name: name() })?;
    let read = |reading: &Reading| Series::read(observed, &used, reading);
    let series = read(&candidates.chosen).ok_or_else(|| VerifyError::NothingTurns { name: name() })?;
    if series.len() < FEWEST_SAMPLES {
        return Err(VerifyError::TooFew { name: name(), samples: series.len() });
    }
    let is_resolved = series.samples_per_turn() >= FEWEST_PER_TURN;
    let kinematics = Kinematics::of(&series, clock.rounding_s).filter(|_| is_resolved);
    let mut verification = Verification {
        name: name(),
        verdict: Verdict::CannotTell,
        reasons: Vec::new(),
        causes: Vec::new(),
        habits: Vec::new(),
        remarks: Vec::new(),
        tolerance_rad,
        length,
        inertia: InertiaFit::of(&series).filter(|_| is_resolved || !series.is_derived),
        candidates,
        kinematics,
        laws: None,
        montgomery: None,
        distance: None,
        clock,
    };
    // Rates found from attitudes that are too far apart are none.
    let body = body.filter(|_| is_resolved || !series.is_derived);
    let mut of_rates = Vec::new();
    if let Some(body) = body {
        let pushed =
            Pushed::of(observed, &body.properties.body_from_principal).filter(|_| body.problem.loads.is_empty());
        let subject = Subject::new(body, &series, pushed.as_ref());
        let steps = Steps::of(&subject, &series, verification.clock.rounding_s, MOST_INTERVALS)?;
        verification.laws = Some(Laws::of(&subject, &series, &steps));
        if !subject.is_free() {
            // It is what turns like that if nothing acts.
            verification.inertia = None;
        }
        if !series.attitude.is_empty() {
            verification.distance = Some(Distance::of(&subject, &series, tolerance_rad)?);
            if subject.is_free() && is_resolved {
                verification.montgomery = Montgomery::of(&subject, &series)?;
            }
        }
        let chosen = verification.candidates.chosen;
        let other = if chosen.axes == Axes::Body { Axes::World } else { Axes::Body };
        let other_frame = (verification.candidates.is_decided && !series.is_derived)
            .then(|| read(&Reading { axes: other, ..chosen }))
            .flatten();
        of_rates = hypotheses::explain(
            body,
            &series,
            other_frame.as_ref().map(|other| (other, chosen.axes)),
            pushed.as_ref(),
            verification.clock.rounding_s,
        )?;
    }
    judge::judge(&mut verification, observed, &series, of_rates);
    if is_general {
        let remark = "loads by a formula, of a spring, in a fluid or of a controller are not held to: only q against ω is judged";
        verification.remarks.push(remark.to_owned());
    }
    Ok(verification)
}
