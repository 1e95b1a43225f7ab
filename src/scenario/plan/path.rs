use super::promise::{Kept, Stepper, keep};
use super::rules::{positive, unused};
use crate::dynamics::{Problem, SpringCloud};
use crate::propagation::{AxialTorque, BrakedRotation, Coverage, FixedStepMethod, Information, LagrangeTop};
use crate::scenario::{Grid, Key, Method, Path, PlannedBody, Refusal, Scenario, ScenarioError, Setting};

/// What is asked of a path that chooses its own steps.
pub enum Accuracy<'a> {
    /// Full accuracy.
    Tightest,
    /// At each step, rad.
    OfStep(f64),
    /// Over the whole run, at these samples, rad.
    Promise(f64, &'a Grid),
}

impl PlannedBody {
    /// The same body by another method; `value` is the tolerance of each step (rad), or the step (s) of a method that is
    /// told one.
    ///
    /// # Errors
    /// If the method does not cover the body, or the value breaks its rule.
    pub fn by(self, method: Method, value: Option<f64>) -> Result<Self, ScenarioError> {
        let of = |setting| value.filter(|_| method.setting() == setting);
        let asked = Scenario { method, step_s: of(Setting::Step), ..Scenario::default() };
        self.asked(asked, &of(Setting::Tolerance).map_or(Accuracy::Tightest, Accuracy::OfStep))
    }

    /// The same body by a method that keeps its attitude error below `tolerance_rad` at the samples of `grid`; `Auto` is
    /// the cheapest that does. Taylor series and DOP853, if asked for, take their tightest where that is not enough, and
    /// the reason says so.
    ///
    /// # Errors
    /// If no method keeps it, the method has no tolerance, or the tolerance breaks its rule.
    pub fn keeping(self, method: Method, tolerance_rad: f64, grid: &Grid) -> Result<Self, ScenarioError> {
        let asked = Scenario { method, tolerance_rad: Some(tolerance_rad), ..Scenario::default() };
        let accuracy = accuracy(&asked, grid).map_err(|refusal| refusal.locate(&asked))?;
        self.asked(asked, &accuracy)
    }

    fn asked(mut self, mut asked: Scenario, accuracy: &Accuracy) -> Result<Self, ScenarioError> {
        asked.file.clone_from(&self.name);
        (self.path, self.reason) =
            choose(&asked, &self.problem, self.moves, accuracy).map_err(|refusal| refusal.locate(&asked))?;
        Ok(self)
    }
}

/// Which propagator a body takes, and why.
pub fn choose(
    scenario: &Scenario,
    problem: &Problem,
    moves: bool,
    accuracy: &Accuracy,
) -> Result<(Path, String), Refusal> {
    let method_key = Key::root("method");
    let known = closed_form(problem, moves);
    let fixed_step = fixed_step(scenario.method);
    if fixed_step.is_none() {
        unused(
            &Key::root("step_s"),
            scenario.step_s.as_ref(),
            "only methods with a fixed step, such as rk4, take one",
        )?;
    }
    if fixed_step.is_some() || scenario.method == Method::ClosedForm {
        let rule = "neither a closed form nor a method with a fixed step has a tolerance";
        unused(&Key::root("tolerance_rad"), scenario.tolerance_rad.as_ref(), rule)?;
    }
    if let Some(method) = fixed_step {
        return with_fixed_step(scenario, problem, method);
    }
    match scenario.method {
        Method::ClosedForm => {
            let rule = "\"closed_form\" knows no form for what acts on this body; use \"auto\"";
            let (path, _) = known.ok_or_else(|| method_key.refuse(rule))?;
            Ok((path, asked("closed_form")))
        }
        Method::Taylor => by_steps(Stepper::Taylor, problem, accuracy, &asked("taylor")),
        Method::Dop853 if let Some(error) = problem.moves_inside() => Err(method_key.refuse(error.rule())),
        Method::Dop853 => by_steps(Stepper::Dop853, problem, accuracy, &asked("dop853")),
        // Left over: "auto".
        _ => known.map_or_else(|| automatic(problem, accuracy), |(path, reason)| Ok((path, reason.to_owned()))),
    }
}

/// A stepper that was asked for, whether it keeps a promise or not.
fn by_steps(stepper: Stepper, problem: &Problem, accuracy: &Accuracy, asked: &str) -> Result<(Path, String), Refusal> {
    let tolerance = match accuracy {
        Accuracy::Tightest => stepper.tightest(),
        Accuracy::OfStep(tolerance) => positive(&Key::root("tolerance_rad"), *tolerance)?,
        Accuracy::Promise(promise, grid) => {
            return Ok(match kept(problem, grid, *promise, &[stepper])? {
                Kept::By(path, found) => (path, format!("{asked}; {found}")),
                Kept::Not(path, found) => {
                    (path, format!("{asked}; its tightest does not keep {promise:e} rad: {found}"))
                }
            });
        }
    };
    Ok((stepper.path(tolerance), asked.to_owned()))
}

/// Of what has no closed form.
fn automatic(problem: &Problem, accuracy: &Accuracy) -> Result<(Path, String), Refusal> {
    let Accuracy::Promise(promise, grid) = accuracy else {
        if let Some(cloud) = problem.cloud() {
            return by_steps(Stepper::Taylor, problem, accuracy, &of_particles(cloud));
        }
        let reason = if problem.is_general() {
            "a load has no recurrence of its own: general Taylor series, by automatic differentiation of all that acts"
        } else {
            "a torque acts: Taylor series are the cheapest way to full accuracy"
        };
        return by_steps(Stepper::Taylor, problem, accuracy, reason);
    };
    match kept(problem, grid, *promise, &[Stepper::Taylor, Stepper::Dop853])? {
        Kept::By(path, found) => {
            Ok((path, format!("a torque acts, and this is the cheapest way to {promise:e} rad: {found}")))
        }
        Kept::Not(_, found) => {
            let rule = format_args!("{promise:?} rad is more than f64 can promise for this motion: {found}");
            Err(Key::root("tolerance_rad").refuse(rule))
        }
    }
}

/// Why a cloud takes Taylor series.
fn of_particles(cloud: &SpringCloud) -> String {
    let hertz = |rate: f64| rate / std::f64::consts::TAU;
    let words = |hz: f64| if (0.01..1e5).contains(&hz) { format!("{hz:.2}") } else { format!("{hz:.2e}") };
    let [lowest, highest] = cloud.natural_frequencies().map(hertz).map(words);
    let count = cloud.masses().len();
    format!(
        "springs join {count} particles, which vibrate at {lowest} to {highest} Hz: Taylor series of each one's equation of motion"
    )
}

fn kept(problem: &Problem, grid: &Grid, promise: f64, steppers: &[Stepper]) -> Result<Kept, Refusal> {
    keep(problem, grid, promise, steppers)
        .map_err(|error| Key::root("tolerance_rad").refuse(format_args!("{promise:?} rad cannot be tried: {error}")))
}

/// The closed form of a motion, if one is known, and why it is one. It must hold whichever channels are watched.
pub fn closed_form(problem: &Problem, moves: bool) -> Option<(Path, &'static str)> {
    if problem.loads.is_empty() {
        return Some((Path::ClosedForm, "no torque acts, so the motion is known in closed form"));
    }
    if BrakedRotation::covers(problem) {
        let reason = "a brake along the angular momentum only slows the torque-free motion, known in closed form";
        return Some((Path::MomentumBrake, reason));
    }
    if AxialTorque::covers(problem) {
        let reason = "the torque is constant along the axis of a steady spin, so the angle is a quadratic of time";
        return Some((Path::AxialTorque, reason));
    }
    if !moves && LagrangeTop::covers(problem) {
        let reason = "a symmetric body under a force or field on its axis is Lagrange's top, known in closed form";
        return Some((Path::LagrangeTop, reason));
    }
    None
}

fn with_fixed_step(scenario: &Scenario, problem: &Problem, method: FixedStepMethod) -> Result<(Path, String), Refusal> {
    let Information { name, coverage, .. } = method.information();
    if let Some(error) = problem.moves_inside() {
        return Err(Key::root("method").refuse(error.rule()));
    }
    if coverage == Coverage::ListedLoads && problem.is_general() {
        let rule = format_args!("\"{name}\" knows the flow of constants, couples and damping only");
        return Err(Key::root("method").refuse(rule));
    }
    if coverage == Coverage::TorqueFree && !problem.loads.is_empty() {
        let rule = format_args!("\"{name}\" needs a body without torques and forces");
        return Err(Key::root("method").refuse(rule));
    }
    if coverage == Coverage::ListedLoads && problem.has_rotor() {
        let rule = format_args!("\"{name}\" does not know how a body that carries a rotor turns; use \"auto\"");
        return Err(Key::root("method").refuse(rule));
    }
    let key = Key::root("step_s");
    let step = scenario.step_s.ok_or_else(|| key.refuse(format_args!("missing: method = \"{name}\" needs it")))?;
    Ok((Path::FixedStep { method, step: positive(&key, step)? }, asked(name)))
}

/// The method with a fixed step of that name, if it is one.
pub const fn fixed_step(method: Method) -> Option<FixedStepMethod> {
    Some(match method {
        Method::Auto | Method::ClosedForm | Method::Taylor | Method::Dop853 => return None,
        Method::EulerNaive => FixedStepMethod::EulerNaive,
        Method::EulerSemiImplicit => FixedStepMethod::EulerSemiImplicit,
        Method::Rk4 => FixedStepMethod::Rk4,
        Method::Rkmk4 => FixedStepMethod::Rkmk4,
        Method::Splitting2 => FixedStepMethod::Splitting2,
        Method::Splitting4 => FixedStepMethod::Splitting4,
        Method::Splitting6 => FixedStepMethod::Splitting6,
        Method::Splitting8 => FixedStepMethod::Splitting8,
        Method::Dmv2 => FixedStepMethod::Dmv2,
        Method::Dmv4 => FixedStepMethod::Dmv4,
        Method::Dmv6 => FixedStepMethod::Dmv6,
        Method::Dmv8 => FixedStepMethod::Dmv8,
        Method::Gauss4 => FixedStepMethod::Gauss4,
        Method::Gauss6 => FixedStepMethod::Gauss6,
        Method::Kicks2 => FixedStepMethod::Kicks2,
        Method::Kicks4 => FixedStepMethod::Kicks4,
    })
}

fn asked(method: &str) -> String {
    format!("method = \"{method}\" was asked for")
}

/// What a scene asks for.
pub fn accuracy<'a>(scenario: &Scenario, grid: &'a Grid) -> Result<Accuracy<'a>, Refusal> {
    let key = Key::root("tolerance_rad");
    let Some(tolerance) = scenario.tolerance_rad else { return Ok(Accuracy::Tightest) };
    if positive(&key, tolerance)? > 0.1 {
        return Err(key.refuse(format_args!("{tolerance:?} rad is no accuracy: at most 0.1")));
    }
    if tolerance < 2e-15 {
        return Err(key.refuse(format_args!("{tolerance:?} rad is below what f64 resolves: at least 2e-15")));
    }
    Ok(Accuracy::Promise(tolerance, grid))
}
