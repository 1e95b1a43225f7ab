use super::cases::{Case, Depth};
use super::row::NoTruth;
use super::settings::{Attempt, most_steps, promises, values};
use super::trial::{Ending, Trial};
use super::truth::Truth;
use super::verdict::Verdict;
use crate::scenario::{Method, Path, Plan, PlannedBody, Scenario, Setting};

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
    let body = |promise: &f64| {
        let plan = Plan::new(&Scenario { tolerance_rad: Some(*promise), ..case.scenario.clone() }).ok()?;
        let body = plan.bodies.into_iter().next()?;
        let steps = matches!(body.path, Path::Taylor { .. } | Path::Dop853 { .. });
        steps.then_some((*promise, body))
    };
    let run = |(promise, body): (f64, PlannedBody)| {
        let trial = Trial::run(&body, Some(promise), truth, (1, most_steps(case, depth)));
        Trial { limit_rad: promise + truth.reference.doubt_rad, ..trial }
    };
    promises(depth).iter().filter_map(body).map(run).collect()
}

/// The run that is least off among those that ended well; else the last.
pub(super) fn best(trials: &[Trial]) -> Option<&Trial> {
    let done = trials.iter().filter(|trial| trial.ending == Ending::Done);
    done.min_by(|a, b| a.error_rad.total_cmp(&b.error_rad)).or(trials.last())
}

impl Cell {
    /// Runs `method` on `case` at every setting.
    pub(super) fn of(case: &Case, method: Method, depth: Depth, truth: Result<&Truth, &NoTruth>) -> Self {
        let none = |verdict, refusal| Self { method, verdict, trials: Vec::new(), refusal };
        let truth = match truth {
            Ok(truth) => truth,
            Err(NoTruth { reason, is_planned }) => {
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
        let broken = promises
            .iter()
            .any(|trial| !trial.is_sound() || trial.error_rad.is_nan() || trial.error_rad > trial.limit_rad);
        let verdict = if broken { Verdict::Wrong } else { Verdict::of(method, &trials) };
        trials.extend(promises);
        Self { method, verdict, trials, refusal: None }
    }

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

    /// The run at the finest setting (tolerance, rad, or step, s) at which it loses the motion; none where it never does.
    #[must_use]
    pub fn broken(&self) -> Option<&Trial> {
        let lost = self.trials.iter().filter(|trial| !trial.follows() && trial.ending != Ending::TooLong);
        lost.min_by(|a, b| a.value.unwrap_or(0.0).total_cmp(&b.value.unwrap_or(0.0)))
    }
}
