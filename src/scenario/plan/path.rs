use super::rules::{positive, unused};
use crate::dynamics::Problem;
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
        (self.path, self.reason) = choose(&asked, &self.problem).map_err(|refusal| refusal.locate(&asked))?;
        Ok(self)
    }
}

/// Which propagator a body takes, and why.
pub fn choose(scenario: &Scenario, problem: &Problem) -> Result<(Path, String), Refusal> {
    let method_key = Key::root("method");
    let is_free = problem.loads.is_empty();
    if scenario.method != Method::Rk4 {
        unused(&Key::root("step_s"), scenario.step_s.as_ref(), "only method = \"rk4\" has a fixed step")?;
    }
    if matches!(scenario.method, Method::Rk4 | Method::ClosedForm) {
        let rule = "a closed form has no tolerance, and rk4 has a fixed step";
        unused(&Key::root("tolerance_rad"), scenario.tolerance_rad.as_ref(), rule)?;
    }
    let tolerance = step_tolerance(scenario)?;
    Ok(match scenario.method {
        Method::Auto if is_free => {
            (Path::ClosedForm, "no torque acts, so the motion is known in closed form".to_owned())
        }
        Method::Auto => {
            let reason = "a torque acts: Taylor series are the cheapest way to full accuracy";
            (Path::Taylor { tolerance }, reason.to_owned())
        }
        Method::ClosedForm if is_free => (Path::ClosedForm, asked("closed_form")),
        Method::ClosedForm => {
            return Err(method_key.refuse("\"closed_form\" needs a body without torques and forces; use \"auto\""));
        }
        Method::Taylor => (Path::Taylor { tolerance }, asked("taylor")),
        Method::Dop853 => (Path::Dop853 { tolerance: tolerance.max(TIGHTEST_DOP853) }, asked("dop853")),
        Method::Rk4 => {
            let key = Key::root("step_s");
            let step = scenario.step_s.ok_or_else(|| key.refuse("missing: method = \"rk4\" needs it"))?;
            (Path::Rk4 { step: positive(&key, step)? }, asked("rk4"))
        }
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
