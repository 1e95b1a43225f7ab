use super::search::{Search, Trial};
use super::timing::interleaved;
use super::{Clock, Reference, Spread, pareto_front, reference_states, wall_clock};
use crate::propagation::{Effort, States};
use crate::scenario::{Method, PlannedBody, ScenarioError};

/// What to measure.
#[derive(Debug, Clone)]
pub struct Request {
    /// By these; `Auto` means the one that it picks.
    pub methods: Vec<Method>,
    /// Attitude errors to reach, rad.
    pub errors_rad: Vec<f64>,
    /// When states are asked for, evenly to the end of the run.
    pub outputs: u32,
    /// A fixed step that needs more evaluations than this is not tried.
    pub evaluations_max: u64,
    /// How long to repeat for the sake of the median, s, for each body.
    pub budget_s: f64,
    /// What measures costs.
    pub clock: Clock,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            methods: vec![
                Method::ClosedForm,
                Method::Taylor,
                Method::Dop853,
                Method::EulerSemiImplicit,
                Method::Rk4,
                Method::Splitting4,
                Method::Gauss6,
            ],
            errors_rad: vec![1e-3, 1e-6, 1e-9, 1e-12],
            outputs: 20,
            evaluations_max: 1_000_000,
            budget_s: 2.0,
            clock: wall_clock,
        }
    }
}

/// Work and precision of methods on one body.
#[derive(Debug, Clone)]
pub struct WorkPrecision {
    /// The body's name.
    pub body: String,
    /// End of the run, s.
    pub end_s: f64,
    /// What errors are measured from.
    pub reference: Reference,
    /// The method that `auto` picks.
    pub auto: Option<Method>,
    /// By method, each from loose to tight.
    pub points: Vec<Point>,
    /// Who reaches which error, and with which of `points`: errors as requested, methods in order.
    pub levels: Vec<Level>,
}

/// One method at one setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// By which.
    pub method: Method,
    /// Tolerance (rad, over the run) or step (s) it was told.
    pub value: Option<f64>,
    /// Largest angle from the reference over all outputs, rad.
    pub error_rad: f64,
    /// Evaluations, steps, rejections.
    pub effort: Effort,
    /// Set-up and all outputs.
    pub cost: Spread,
    /// Whether no other point is cheaper at this error and more accurate at this cost.
    pub is_on_front: bool,
}

/// The cheapest way of one method to one error.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Requested, rad.
    pub error_rad: f64,
    /// By which.
    pub method: Method,
    /// Index of the point that costs least among those that reach it; `None` where none does.
    pub point: Option<usize>,
}

/// Runs every method of `request` on `body` up to `end_s`, searches the cheapest setting for each error, and times all.
///
/// Errors, evaluations and steps are the same every time; costs are not.
///
/// # Errors
/// If the reference cannot be had, or a method fails for another reason than want of accuracy.
pub fn work_precision(body: &PlannedBody, end_s: f64, request: &Request) -> Result<WorkPrecision, ScenarioError> {
    let mut body = body.clone();
    body.problem.wants_attitude = true;
    body.problem.wants_translation = false;
    let times: Vec<f64> =
        (1..=request.outputs).map(|index| end_s * f64::from(index) / f64::from(request.outputs)).collect();
    let reference = reference_states(&body, &times)?;
    let auto = picked_by_auto(&body)?;
    let search = Search { body: &body, times: &times, reference: &reference, evaluations_max: request.evaluations_max };
    let mut trials: Vec<(Method, Trial)> = Vec::new();
    let methods = distinct(&request.methods, auto);
    for method in &methods {
        trials.extend(search.trials(*method, &request.errors_rad)?.into_iter().map(|trial| (*method, trial)));
    }
    let points = timed(trials, &times, &reference, request);
    let levels = request.errors_rad.iter().flat_map(|error_rad| {
        // A method that does not cover the body has no points, and is not said to miss anything.
        let covering = methods.iter().filter(|method| points.iter().any(|point| point.method == **method));
        covering.map(|method| Level { error_rad: *error_rad, method: *method, point: None })
    });
    let levels = levels.map(|level| Level { point: cheapest(&points, &level), ..level }).collect();
    Ok(WorkPrecision { body: body.name, end_s, reference, auto, points, levels })
}

/// The method whose path `auto` takes.
fn picked_by_auto(body: &PlannedBody) -> Result<Option<Method>, ScenarioError> {
    let picked = std::mem::discriminant(&body.clone().by(Method::Auto, None)?.path);
    // Any positive number does as tolerance or step: only the kind of path is looked at.
    let takes_it = |method: &Method| {
        let path = body.clone().by(*method, Some(1e-3)).map(|body| std::mem::discriminant(&body.path));
        *method != Method::Auto && path.is_ok_and(|path| path == picked)
    };
    Ok(Method::ALL.into_iter().find(takes_it))
}

/// The methods asked for, `Auto` as the one it picks, each once.
fn distinct(methods: &[Method], auto: Option<Method>) -> Vec<Method> {
    let mut distinct = Vec::new();
    for method in methods {
        let method = if *method == Method::Auto { auto } else { Some(*method) };
        distinct.extend(method.filter(|method| !distinct.contains(method)));
    }
    distinct
}

fn timed(trials: Vec<(Method, Trial)>, times: &[f64], reference: &Reference, request: &Request) -> Vec<Point> {
    let work = |trial: &Trial| {
        let (body, mut states) = (trial.body.clone(), States::default());
        move || {
            // The same run has just succeeded.
            let done = body.propagator().and_then(|mut propagator| propagator.fill(times, &mut states));
            assert!(std::hint::black_box(done).is_ok(), "a run that succeeded fails when repeated");
        }
    };
    let mut works: Vec<_> = trials.iter().map(|(_, trial)| work(trial)).collect();
    let costs = interleaved(&mut works, request.clock, request.budget_s);
    let pairs: Vec<_> = trials.iter().zip(&costs).map(|((_, trial), cost)| (trial.error_rad, cost.median_s)).collect();
    let front = pareto_front(&pairs, reference.doubt_rad);
    let point = |(((method, trial), cost), is_on_front)| {
        let Trial { value, error_rad, effort, .. } = trial;
        Point { method, value, error_rad, effort, cost, is_on_front }
    };
    trials.into_iter().zip(costs).zip(front).map(point).collect()
}

fn cheapest(points: &[Point], level: &Level) -> Option<usize> {
    let reaches = |point: &&Point| point.method == level.method && point.error_rad <= level.error_rad;
    let cheapest = points.iter().filter(reaches).map(|point| point.cost.median_s).fold(f64::INFINITY, f64::min);
    points.iter().position(|point| reaches(&point) && point.cost.median_s == cheapest)
}
