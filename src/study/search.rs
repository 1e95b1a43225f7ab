use super::Reference;
use crate::propagation::{Effort, PropagationError, States, attitude_distance};
use crate::scenario::{Method, PlannedBody, ScenarioError, Setting};

/// One run of a method: what it was told, how far off it was, what it did.
#[derive(Debug, Clone)]
pub(super) struct Trial {
    /// Tolerance of a step, rad, or step, s.
    pub value: Option<f64>,
    pub error_rad: f64,
    pub effort: Effort,
    pub body: PlannedBody,
}

/// Halvings of a decade (of a factor 2 for steps) in search of the cheapest value.
const HALVINGS: usize = 4;
/// Decades of tolerance, from the loosest.
const DECADES: i32 = 15;
const LOOSEST: f64 = 0.1;

/// Tries settings of one method on one body.
pub(super) struct Search<'a> {
    pub body: &'a PlannedBody,
    pub times: &'a [f64],
    pub reference: &'a Reference,
    /// A fixed step that needs more evaluations than this is not tried.
    pub evaluations_max: u64,
}

impl Search<'_> {
    /// Every trial made of `method`, each requested error reached as cheaply as can be, from loose to tight; empty where
    /// the method does not cover the body.
    pub fn trials(&self, method: Method, errors_rad: &[f64]) -> Result<Vec<Trial>, ScenarioError> {
        if self.body.clone().by(method, self.loosest(method)).is_err() {
            return Ok(Vec::new());
        }
        let mut trials = self.scan(method, errors_rad)?;
        for error in errors_rad {
            let Some(index) = trials.iter().position(|trial| trial.error_rad <= *error) else { continue };
            let (Some(mut tight), true) = (trials[index].value, index > 0) else { continue };
            let Some(mut loose) = trials[index - 1].value else { continue };
            for _ in 0..HALVINGS {
                let value = (loose * tight).sqrt();
                let Some(trial) = self.trial(method, Some(value))? else { break };
                if trial.error_rad <= *error {
                    tight = value;
                } else {
                    loose = value;
                }
                trials.push(trial);
            }
            trials.sort_by(|a, b| b.value.partial_cmp(&a.value).unwrap_or(std::cmp::Ordering::Equal));
        }
        Ok(trials)
    }

    fn loosest(&self, method: Method) -> Option<f64> {
        match method.setting() {
            Setting::None => None,
            Setting::Tolerance => Some(LOOSEST),
            Setting::Step => self.times.first().copied(),
        }
    }

    /// A trial for each decade of tolerance, or each halving of the step, until the tightest error is reached.
    fn scan(&self, method: Method, errors_rad: &[f64]) -> Result<Vec<Trial>, ScenarioError> {
        let tightest = errors_rad.iter().copied().fold(f64::INFINITY, f64::min);
        let mut trials: Vec<Trial> = Vec::new();
        let mut next = self.loosest(method);
        loop {
            let trial = self.trial(method, next)?;
            let evaluations = trial.as_ref().map_or(0, |trial| trial.effort.evaluations);
            let is_enough = trial.as_ref().is_some_and(|trial| trial.error_rad <= tightest);
            trials.extend(trial);
            next = match (method.setting(), next) {
                (Setting::Tolerance, Some(value)) if value > LOOSEST * 10_f64.powi(-DECADES) * 1.5 => {
                    Some((value / 10.0).max(1e-16))
                }
                (Setting::Step, Some(value)) if 2 * evaluations <= self.evaluations_max => Some(value / 2.0),
                _ => return Ok(trials),
            };
            if is_enough {
                return Ok(trials);
            }
        }
    }

    /// One run; `None` where it fails for want of accuracy: it left the numbers, its step vanished, or was too long to be solved.
    fn trial(&self, method: Method, value: Option<f64>) -> Result<Option<Trial>, ScenarioError> {
        let body = self.body.clone().by(method, value)?;
        let (mut propagator, mut states) = (body.propagator()?, States::default());
        match propagator.fill(self.times, &mut states) {
            Ok(()) => {}
            Err(
                PropagationError::NotFinite { .. }
                | PropagationError::StepTooSmall { .. }
                | PropagationError::NoConvergence { .. },
            ) => return Ok(None),
            Err(error) => return Err(error.into()),
        }
        let error_rad = attitude_distance(&self.reference.states, &states);
        Ok(Some(Trial { value, error_rad, effort: propagator.effort(), body }))
    }
}
