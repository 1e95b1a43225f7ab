use super::search::{Candidate, Stepper, search};
use super::trials::Trials;
use crate::dynamics::Problem;
use crate::propagation::{PropagationError, Taylor};
use crate::scenario::{Grid, Path};

// What runs cost, in evaluations of the right-hand side as DOP853 makes them: rounded from times of both on the torques of
// the tests, so that which is cheaper is right to a factor of one and a half.
/// The interpolant of a step that holds samples.
const DOP853_INTERPOLANT: f64 = 3.0;
/// A sample of it.
const DOP853_SAMPLE: f64 = 1.0;
/// A Taylor step of order 0, and what it costs more by the square of its order.
const TAYLOR_STEP: f64 = 2.0;
const TAYLOR_PRODUCT: f64 = 0.03;
/// A term of a Taylor sample.
const TAYLOR_TERM: f64 = 0.05;

/// What is known of a promise before the run.
#[derive(Debug, Clone)]
pub enum Kept {
    /// It is kept by this path, for this reason.
    By(Path, String),
    /// It is not: the path that comes nearest, and how near.
    Not(Path, String),
}

/// The cheapest of `steppers`, and the loosest of its tolerances within a factor, that keeps the attitude error below
/// `promise` rad at the samples of `grid`.
///
/// # Errors
/// If the motion cannot be propagated at full accuracy.
pub fn keep(problem: &Problem, grid: &Grid, promise: f64, steppers: &[Stepper]) -> Result<Kept, PropagationError> {
    let trials = Trials::new(problem, grid)?;
    let candidates = if trials.floor() <= promise { candidates(&trials, promise, steppers) } else { Vec::new() };
    let cheapest = candidates.iter().min_by(|a, b| cost(problem, a, grid).total_cmp(&cost(problem, b, grid)));
    let Some(Candidate { stepper, tolerance, trial }) = cheapest else {
        let (path, off) = nearest(&trials, steppers);
        let words = format!("about {off:.1e} rad off{}{}", reach(&trials, grid), until(&trials, promise));
        return Ok(Kept::Not(path, words));
    };
    let off = trial.error.max(trials.floor());
    let words = format!("a trial is {off:.1e} rad off, {promise:e} are allowed{}", reach(&trials, grid));
    Ok(Kept::By(stepper.path(*tolerance), words))
}

fn candidates(trials: &Trials, promise: f64, steppers: &[Stepper]) -> Vec<Candidate> {
    steppers.iter().filter_map(|stepper| search(trials, *stepper, promise)).collect()
}

/// The first stepper at its tightest, and about how far it is off, rad.
fn nearest(trials: &Trials, steppers: &[Stepper]) -> (Path, f64) {
    let stepper = steppers.first().copied().unwrap_or(Stepper::Taylor);
    let error = trials.by(stepper, stepper.tightest()).map_or(f64::INFINITY, |trial| trial.error);
    (stepper.path(stepper.tightest()), error.max(trials.floor()))
}

/// About what a run costs, in evaluations of the right-hand side as DOP853 makes them.
#[expect(clippy::cast_precision_loss, reason = "an estimate")]
fn cost(problem: &Problem, candidate: &Candidate, grid: &Grid) -> f64 {
    let Candidate { stepper, tolerance, trial } = candidate;
    let samples = grid.len() as f64;
    let steps = trial.effort.steps as f64;
    match stepper {
        Stepper::Dop853 => {
            let sampling = DOP853_INTERPOLANT * steps.min(samples) + DOP853_SAMPLE * samples;
            trial.effort.evaluations as f64 + sampling
        }
        Stepper::Taylor => {
            let order = Taylor::new(problem, *tolerance).map_or(0, |taylor| taylor.order()) as f64;
            steps * (TAYLOR_STEP + TAYLOR_PRODUCT * order * order) + TAYLOR_TERM * order * samples
        }
    }
}

/// How far the trial went, where that is not the whole run.
fn reach(trials: &Trials, grid: &Grid) -> String {
    if trials.growth > 1.0 {
        format!(" (tried to t = {:e} s, and taken to grow as t² to {:e} s)", trials.end(), grid.end())
    } else {
        String::new()
    }
}

/// How long the promise could be kept, if not for the whole run.
fn until(trials: &Trials, promise: f64) -> String {
    let time = trials.floor_below_until(promise);
    if time < trials.end() { format!("; f64 keeps {promise:e} rad to about t = {time:.3e} s") } else { String::new() }
}
