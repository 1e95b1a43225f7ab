use super::rules::{positive, unused};
use crate::dynamics::Problem;
use crate::propagation::{AxialTorque, BrakedRotation, Coverage, FixedStepMethod, Information, LagrangeTop};
use crate::scenario::{Key, Method, Path, PlannedBody, Refusal, Scenario, ScenarioError, Setting};

/// Per step, where no tolerance is asked for: as tight as f64 carries.
const TIGHTEST: f64 = 1e-16;
/// Per step, the least that DOP853's error estimate can tell.
const TIGHTEST_DOP853: f64 = 1e-15;
/// Share of the whole run's tolerance that one step may spend.
const SHARE_OF_A_STEP: f64 = 1e-2;

impl PlannedBody {
    /// The same body by another method, under the rules of scenes; `value` is the tolerance (rad, over the whole run)
    /// or the step (s) of a method that is told one.
    ///
    /// # Errors
    /// If the method does not cover the body, or the value breaks its rule.
    pub fn by(mut self, method: Method, value: Option<f64>) -> Result<Self, ScenarioError> {
        let of = |setting| value.filter(|_| method.setting() == setting);
        let asked = Scenario {
            method,
            tolerance_rad: of(Setting::Tolerance),
            step_s: of(Setting::Step),
            file: self.name.clone(),
            ..Scenario::default()
        };
        (self.path, self.reason) =
            choose(&asked, &self.problem, self.moves).map_err(|refusal| refusal.locate(&asked))?;
        Ok(self)
    }
}

/// Which propagator a body takes, and why.
pub fn choose(scenario: &Scenario, problem: &Problem, moves: bool) -> Result<(Path, String), Refusal> {
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
        return with_fixed_step(scenario, problem.loads.is_empty(), method);
    }
    let tolerance = step_tolerance(scenario)?;
    Ok(match scenario.method {
        Method::ClosedForm => {
            let rule = "\"closed_form\" knows no form for what acts on this body; use \"auto\"";
            let (path, _) = known.ok_or_else(|| method_key.refuse(rule))?;
            (path, asked("closed_form"))
        }
        Method::Taylor => (Path::Taylor { tolerance }, asked("taylor")),
        Method::Dop853 => (Path::Dop853 { tolerance: tolerance.max(TIGHTEST_DOP853) }, asked("dop853")),
        // Left over: "auto".
        _ => known.map_or_else(
            || {
                let reason = "a torque acts: Taylor series are the cheapest way to full accuracy";
                (Path::Taylor { tolerance }, reason.to_owned())
            },
            |(path, reason)| (path, reason.to_owned()),
        ),
    })
}

/// The closed form of a motion, if one is known, and why it is one. It must hold whichever channels are watched.
fn closed_form(problem: &Problem, moves: bool) -> Option<(Path, &'static str)> {
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
        let reason = "a symmetric body under a force on its axis is Lagrange's top, known in closed form";
        return Some((Path::LagrangeTop, reason));
    }
    None
}

fn with_fixed_step(scenario: &Scenario, is_free: bool, method: FixedStepMethod) -> Result<(Path, String), Refusal> {
    let Information { name, coverage, .. } = method.information();
    if coverage == Coverage::TorqueFree && !is_free {
        let rule = format_args!("\"{name}\" needs a body without torques and forces");
        return Err(Key::root("method").refuse(rule));
    }
    let key = Key::root("step_s");
    let step = scenario.step_s.ok_or_else(|| key.refuse(format_args!("missing: method = \"{name}\" needs it")))?;
    Ok((Path::FixedStep { method, step: positive(&key, step)? }, asked(name)))
}

/// The method with a fixed step of that name, if it is one.
const fn fixed_step(method: Method) -> Option<FixedStepMethod> {
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

fn step_tolerance(scenario: &Scenario) -> Result<f64, Refusal> {
    let key = Key::root("tolerance_rad");
    let Some(tolerance) = scenario.tolerance_rad else { return Ok(TIGHTEST) };
    if positive(&key, tolerance)? > 0.1 {
        return Err(key.refuse(format_args!("{tolerance:?} rad is no accuracy: at most 0.1")));
    }
    if tolerance < 1e-15 {
        return Err(key.refuse(format_args!("{tolerance:?} rad is below what f64 resolves: at least 1e-15")));
    }
    Ok((tolerance * SHARE_OF_A_STEP).max(TIGHTEST))
}
