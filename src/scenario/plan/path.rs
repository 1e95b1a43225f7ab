use super::rules::{positive, unused};
use crate::dynamics::Problem;
use crate::propagation::{Coverage, FixedStepMethod, Information};
use crate::scenario::{Key, Method, Path, Refusal, Scenario};

/// Per step, where no tolerance is asked for: as tight as f64 carries.
const TIGHTEST: f64 = 1e-16;
/// Per step, the least that DOP853's error estimate can tell.
const TIGHTEST_DOP853: f64 = 1e-15;
/// Share of the whole run's tolerance that one step may spend.
const SHARE_OF_A_STEP: f64 = 1e-2;

/// Which propagator a body takes, and why.
pub fn choose(scenario: &Scenario, problem: &Problem) -> Result<(Path, String), Refusal> {
    let method_key = Key::root("method");
    let is_free = problem.loads.is_empty();
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
        return with_fixed_step(scenario, is_free, method);
    }
    let tolerance = step_tolerance(scenario)?;
    Ok(match scenario.method {
        Method::ClosedForm if is_free => (Path::ClosedForm, asked("closed_form")),
        Method::ClosedForm => {
            return Err(method_key.refuse("\"closed_form\" needs a body without torques and forces; use \"auto\""));
        }
        Method::Taylor => (Path::Taylor { tolerance }, asked("taylor")),
        Method::Dop853 => (Path::Dop853 { tolerance: tolerance.max(TIGHTEST_DOP853) }, asked("dop853")),
        // Left over: "auto".
        _ if is_free => (Path::ClosedForm, "no torque acts, so the motion is known in closed form".to_owned()),
        _ => {
            let reason = "a torque acts: Taylor series are the cheapest way to full accuracy";
            (Path::Taylor { tolerance }, reason.to_owned())
        }
    })
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
