use super::search::{Search, Trial};
use super::timing::interleaved;
use super::{Clock, Reference, Spread, pareto_front, reference_states, wall_clock};
use crate::propagation::{Effort, States};
use crate::scenario::{Grid, Method, PlannedBody, ScenarioError};

/// What to measure.
#[derive(Debug, Clone)]
pub struct Request {
    /// By these; `Auto` means those that it picks for the errors.
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
    /// The method that `auto` picks where no tolerance is asked for.
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
    /// Tolerance of a step (rad), or step (s), that it was told.
    pub value: Option<f64>,
    /// Largest angle from the reference over all outputs, rad.
    pub error_rad: f64,
    /// Evaluations, steps, rejections.
    pub effort: Effort,
    /// Set-up and all outputs.
    pub cost: Spread,
    /// Whether its error is at most 0.1 rad, and no other point is cheaper at this error and more accurate at this cost.
    pub is_on_front: bool,
}

/// The cheapest way of one method to one error.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Requested, rad.
    pub error_rad: f64,
    /// By which.
    pub method: Method,
    /// Whether `auto` picks it for a `tolerance_rad` of this error.
    pub is_auto: bool,
    /// Index of the point that costs least among those that reach it; `None` where none does.
    pub point: Option<usize>,
}

/// rad: a larger error is no result, and on no front.
const WORST: f64 = 0.1;

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
    let auto = method_of(&body, &body.clone().by(Method::Auto, None)?);
    let grid = Grid::List(times.clone());
    // What cannot be promised is tried at full accuracy.
    let picked =
        |error: &f64| body.clone().keeping(Method::Auto, *error, &grid).map_or(auto, |kept| method_of(&body, &kept));
    let picks: Vec<Option<Method>> = request.errors_rad.iter().map(picked).collect();
    let search = Search { body: &body, times: &times, reference: &reference, evaluations_max: request.evaluations_max };
    let mut trials: Vec<(Method, Trial)> = Vec::new();
    let methods = distinct(&request.methods, &picks);
    for method in &methods {
        trials.extend(search.trials(*method, &request.errors_rad)?.into_iter().map(|trial| (*method, trial)));
    }
    let points = timed(trials, &times, &reference, request);
    let levels = request.errors_rad.iter().zip(&picks).flat_map(|(error_rad, pick)| {
        // A method that does not cover the body has no points, and is not said to miss anything.
        let covering = methods.iter().filter(|method| points.iter().any(|point| point.method == **method));
        let level = |method: &Method| (*error_rad, *method, *pick == Some(*method));
        covering.map(level).map(|(error_rad, method, is_auto)| Level { error_rad, method, is_auto, point: None })
    });
    let levels = levels.map(|level| Level { point: cheapest(&points, &level), ..level }).collect();
    Ok(WorkPrecision { body: body.name, end_s, reference, auto, points, levels })
}

/// The method whose kind of path a body has taken.
fn method_of(body: &PlannedBody, taken: &PlannedBody) -> Option<Method> {
    let kind = std::mem::discriminant(&taken.path);
    // Any positive number does as tolerance or step: only the kind of path is looked at.
    let takes_it = |method: &Method| {
        let path = body.clone().by(*method, Some(1e-3)).map(|body| std::mem::discriminant(&body.path));
        *method != Method::Auto && path.is_ok_and(|path| path == kind)
    };
    Method::ALL.into_iter().find(takes_it)
}

/// The methods asked for, `Auto` as those it picks, each once.
fn distinct(methods: &[Method], picks: &[Option<Method>]) -> Vec<Method> {
    let mut distinct = Vec::new();
    for method in methods {
        let picked: Vec<Method> =
            if *method == Method::Auto { picks.iter().flatten().copied().collect() } else { vec![*method] };
        for method in picked {
            if !distinct.contains(&method) {
                distinct.push(method);
            }
        }
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
    let error = |trial: &Trial| if trial.error_rad > WORST { f64::INFINITY } else { trial.error_rad };
    let pairs: Vec<_> = trials.iter().zip(&costs).map(|((_, trial), cost)| (error(trial), cost.median_s)).collect();
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
