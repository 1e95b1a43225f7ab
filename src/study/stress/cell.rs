use super::case::{Case, Depth};
use super::trial::{Ending, Trial};
use super::truth::Truth;
use crate::scenario::{Method, Plan, PlannedBody, Scenario, Setting};

/// One case by every method.
#[derive(Debug, Clone)]
pub struct Row {
    /// The motion.
    pub case: Case,
    /// What errors are measured from; or why there is nothing to measure: the refusal of the scene before any run.
    pub truth: Result<Truth, String>,
    /// In the order of the methods asked for.
    pub cells: Vec<Cell>,
}

/// One case by one method.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// By which.
    pub method: Method,
    /// How it ended, all in all.
    pub verdict: Verdict,
    /// Every run, from coarse to fine.
    pub trials: Vec<Trial>,
    /// Why there was none.
    pub refusal: Option<String>,
}

/// How a method fares on a case; at its finest setting, where it has several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Within its limit: as right as f64 and the motion allow, and as what was promised.
    Kept,
    /// It follows the motion, less exactly than f64 allows.
    Coarse,
    /// The motion itself magnifies single roundings to more than 0.1 rad, and nothing can be asked of it.
    Chaotic,
    /// It loses the motion, or ends with an error on the way.
    Lost,
    /// What it gave must never be given: beyond its promise, not finite without an error, not of unit length, or with a jump
    /// of the quaternion's sign. Of `auto`, an error on the way, too.
    Wrong,
    /// Refused before the run, with a reason.
    Refused,
    /// Not tried: it would take too many steps.
    TooLong,
    /// Run, perhaps, but there is nothing to measure it by.
    Unjudged,
}

/// Steps to a turn of the fastest rate.
const QUICK_PACES: [u32; 2] = [16, 128];
const FULL_PACES: [u32; 9] = [4, 8, 16, 32, 64, 128, 256, 1024, 4096];
/// Tolerances of a step, rad; the tightest comes after them.
const QUICK_TOLERANCES: [f64; 1] = [1e-6];
const FULL_TOLERANCES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// Errors over the whole run that `auto` is asked to keep where it steps, rad.
const QUICK_PROMISES: [f64; 1] = [1e-8];
const FULL_PROMISES: [f64; 3] = [1e-4, 1e-7, 1e-10];
/// Taylor series and DOP853 at their tightest take about so many steps to a turn.
const ADAPTIVE_PACE: f64 = 16.0;

/// Runs `methods` on `case`.
#[must_use]
pub fn stress(case: &Case, methods: &[Method], depth: Depth) -> Row {
    let truth = truth(case);
    let cells = methods.iter().map(|method| cell(case, *method, depth, truth.as_ref())).collect();
    Row { case: case.clone(), truth: truth.map_err(|refusal| refusal.reason), cells }
}

/// Why there is nothing to measure.
struct Refusal {
    reason: String,
    /// Whether the scene is refused by its plan, rather than the reference at a loss.
    is_planned: bool,
}

fn truth(case: &Case) -> Result<Truth, Refusal> {
    let plan = Plan::new(&case.scenario).map_err(|error| Refusal { reason: error.to_string(), is_planned: true })?;
    let mut times = Vec::new();
    plan.grid.fill(0, usize::MAX, &mut times);
    let truth = plan.bodies.first().map(|body| Truth::of(body, times));
    let lost = |reason: String| Refusal { reason, is_planned: false };
    truth.ok_or_else(|| lost("no body".to_owned()))?.map_err(|error| lost(error.to_string()))
}

fn cell(case: &Case, method: Method, depth: Depth, truth: Result<&Truth, &Refusal>) -> Cell {
    let none = |verdict, refusal| Cell { method, verdict, trials: Vec::new(), refusal };
    let truth = match truth {
        Ok(truth) => truth,
        Err(Refusal { reason, is_planned }) => {
            // A reference at a loss is no excuse for what is promised.
            let verdict = match (is_planned, method) {
                (true, Method::Auto) => Verdict::Refused,
                (false, Method::Auto) => Verdict::Wrong,
                _ => Verdict::Unjudged,
            };
            return none(verdict, Some(reason.clone()));
        }
    };
    let values = values(case, method, depth, truth);
    if values.is_empty() {
        return none(Verdict::TooLong, None);
    }
    let mut trials = Vec::new();
    for Attempt { value, stride } in values {
        match planned(case, method, value) {
            Ok(body) => trials.push(Trial::run(&body, value, truth, (stride, most_steps(case, depth)))),
            Err(refusal) => return none(Verdict::Refused, Some(refusal)),
        }
    }
    let promises: Vec<Trial> = if method == Method::Auto { promised(case, depth, truth) } else { Vec::new() };
    let broken =
        promises.iter().any(|trial| !trial.is_sound() || trial.error_rad.is_nan() || trial.error_rad > trial.limit_rad);
    let verdict = if broken { Verdict::Wrong } else { verdict(method, &trials) };
    trials.extend(promises);
    Cell { method, verdict, trials, refusal: None }
}

/// A setting, and how many of the truth's times it goes on by.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Attempt {
    value: Option<f64>,
    stride: usize,
}

impl Attempt {
    const fn at_each_time(value: Option<f64>) -> Self {
        Self { value, stride: 1 }
    }

    /// The step near `wanted`, s, of which a whole number makes the way to the next of the times compared, or that makes
    /// the way past a whole number of them.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most the number of times")]
    fn of_step(wanted: f64, interval: f64) -> Self {
        if wanted > interval {
            let stride = (wanted / interval).round();
            return Self { value: Some(stride * interval), stride: stride as usize };
        }
        Self::at_each_time(Some(interval / (interval / wanted).ceil()))
    }
}

/// Settings to try, from coarse to fine, as far as they do not take too long.
fn values(case: &Case, method: Method, depth: Depth, truth: &Truth) -> Vec<Attempt> {
    let span = truth.times_s.last().copied().unwrap_or(0.0);
    let turn = if truth.fastest * span > 1.0 { std::f64::consts::TAU / truth.fastest } else { span };
    let most = exact(most_steps(case, depth));
    match method.setting() {
        Setting::None => vec![Attempt::at_each_time(None)],
        Setting::Tolerance if span / turn * ADAPTIVE_PACE > most => Vec::new(),
        Setting::Tolerance => {
            let tolerances: &[f64] = if depth == Depth::Quick { &QUICK_TOLERANCES } else { &FULL_TOLERANCES };
            tolerances.iter().copied().map(Some).chain([None]).map(Attempt::at_each_time).collect()
        }
        Setting::Step => {
            let paces: &[u32] = match (case.pace.as_ref(), depth) {
                (Some(pace), _) => std::slice::from_ref(pace),
                (None, Depth::Quick) => &QUICK_PACES,
                (None, Depth::Full) => &FULL_PACES,
            };
            let interval = truth.times_s.get(1).copied().unwrap_or(span);
            let steps = paces.iter().map(|pace| turn / f64::from(*pace)).filter(|step| span / step <= most);
            let mut attempts: Vec<Attempt> = steps.map(|step| Attempt::of_step(step, interval)).collect();
            attempts.dedup();
            attempts
        }
    }
}

/// Steps of one run at most.
fn most_steps(case: &Case, depth: Depth) -> u64 {
    match (case.pace, depth) {
        (Some(_), _) => 110_000_000,
        (None, Depth::Quick) => 6_000,
        (None, Depth::Full) => 3_000_000,
    }
}

/// The body as a scene's plan has it, with its method; steps come from the scene, tolerances of steps do not.
fn planned(case: &Case, method: Method, value: Option<f64>) -> Result<PlannedBody, String> {
    let step_s = value.filter(|_| method.setting() == Setting::Step);
    let scenario = Scenario { method, step_s, ..case.scenario.clone() };
    let plan = Plan::new(&scenario).map_err(|error| error.to_string())?;
    let body = plan.bodies.into_iter().next().ok_or("no body")?;
    let body = if step_s.is_some() || value.is_none() { Ok(body) } else { body.by(method, value) };
    let mut body = body.map_err(|error| error.to_string())?;
    body.problem.wants_attitude = true;
    body.problem.wants_translation = false;
    Ok(body)
}

/// What `auto` does for errors over the whole run; where a promise is refused, there is nothing to hold it to.
fn promised(case: &Case, depth: Depth, truth: &Truth) -> Vec<Trial> {
    let promises: &[f64] = if depth == Depth::Quick { &QUICK_PROMISES } else { &FULL_PROMISES };
    let body = |promise: &f64| {
        let plan = Plan::new(&Scenario { tolerance_rad: Some(*promise), ..case.scenario.clone() }).ok()?;
        let body = plan.bodies.into_iter().next()?;
        let steps = matches!(body.path, crate::scenario::Path::Taylor { .. } | crate::scenario::Path::Dop853 { .. });
        steps.then_some((*promise, body))
    };
    let run = |(promise, body): (f64, PlannedBody)| {
        let trial = Trial::run(&body, Some(promise), truth, (1, most_steps(case, depth)));
        Trial { limit_rad: promise + truth.reference.doubt_rad, ..trial }
    };
    promises.iter().filter_map(body).map(run).collect()
}

fn verdict(method: Method, trials: &[Trial]) -> Verdict {
    if !trials.iter().all(Trial::is_sound) {
        return Verdict::Wrong;
    }
    let Some(finest) = best(trials) else { return Verdict::TooLong };
    let is_bound = matches!(method, Method::Auto | Method::ClosedForm);
    let is_done = finest.ending == Ending::Done;
    if finest.ending == Ending::TooLong {
        Verdict::TooLong
    } else if is_done && finest.limit_rad > Trial::LOST_RAD {
        Verdict::Chaotic
    } else if is_done && finest.error_rad <= finest.limit_rad {
        Verdict::Kept
    } else if is_bound {
        Verdict::Wrong
    } else if finest.follows() {
        Verdict::Coarse
    } else {
        Verdict::Lost
    }
}

/// The run that is least off among those that ended well; else the last.
fn best(trials: &[Trial]) -> Option<&Trial> {
    let done = trials.iter().filter(|trial| trial.ending == Ending::Done);
    done.min_by(|a, b| a.error_rad.total_cmp(&b.error_rad)).or(trials.last())
}

impl Cell {
    /// The run that is least off; none where nothing was run.
    #[must_use]
    pub fn best(&self) -> Option<&Trial> {
        best(&self.trials)
    }

    /// In three letters, digits and a sign, so that it reads without colour.
    ///
    /// How many digits of the attitude are right, −log₁₀ of the error in rad, and `=` for [`Verdict::Kept`], `~` for
    /// [`Verdict::Coarse`]; without digits `c` for [`Verdict::Chaotic`], `x` for [`Verdict::Lost`], `!!` for
    /// [`Verdict::Wrong`], `–` for [`Verdict::Refused`], `.` for [`Verdict::TooLong`], `?` for [`Verdict::Unjudged`].
    #[must_use]
    pub fn sign(&self) -> String {
        match self.verdict {
            Verdict::Kept => format!("{}=", self.digits()),
            Verdict::Coarse => format!("{}~", self.digits()),
            Verdict::Chaotic => "c".to_owned(),
            Verdict::Lost => "x".to_owned(),
            Verdict::Wrong => "!!".to_owned(),
            Verdict::Refused => "–".to_owned(),
            Verdict::TooLong => ".".to_owned(),
            Verdict::Unjudged => "?".to_owned(),
        }
    }

    /// Digits of the attitude that are right at its best, as far as the reference tells: 0 to 16.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 0 to 16")]
    pub fn digits(&self) -> u32 {
        // A reference rounded to f64 is in doubt by 2e-16 at least: that much is not told apart.
        let told = |trial: &Trial| {
            if trial.doubt_rad > 1e-15 { trial.error_rad.max(trial.doubt_rad) } else { trial.error_rad }
        };
        let error = self.best().map_or(1.0, told);
        (-libm::log10(error.max(1e-16))).floor().max(0.0) as u32
    }

    /// The finest setting (tolerance, rad, or step, s) at which it loses the motion.
    #[must_use]
    pub fn breaks_at(&self) -> Option<f64> {
        let lost = self.trials.iter().filter(|trial| !trial.follows()).filter_map(|trial| trial.value);
        lost.min_by(f64::total_cmp)
    }
}

/// A count as f64, where a rounding is nothing.
#[expect(clippy::cast_precision_loss, reason = "a bound")]
fn exact(count: u64) -> f64 {
    count as f64
}
