use super::{Grid, Path, PlannedBody};
use crate::propagation::{Dop853, PropagationError, Propagator, Taylor};

/// What a run of one body is expected to cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cost {
    /// Samples, each told by a closed form or by a step's polynomial.
    pub samples: u64,
    /// Steps; none of a closed form.
    pub steps: u64,
    /// Whether the steps were counted on a first part of the run, and carried on to its end.
    pub is_estimate: bool,
}

/// Steps that are tried.
const TRIED: u64 = 1000;

impl PlannedBody {
    /// What a run to the end of `grid` costs: asked of a trial of a thousand steps.
    ///
    /// # Errors
    /// If the trial cannot be propagated.
    pub fn cost(&self, grid: &Grid) -> Result<Cost, PropagationError> {
        let (steps, is_estimate) = match self.path {
            Path::FixedStep { step, .. } => (equal_steps(grid, step), false),
            Path::Taylor { tolerance } => {
                let mut trial = Taylor::new(&self.problem, tolerance)?;
                let reached = trial.reach(grid.end(), TRIED)?;
                carried_on(trial.effort().steps, reached, grid.end())
            }
            Path::Dop853 { tolerance } => {
                let mut trial = Dop853::new(&self.problem, tolerance)?;
                let reached = trial.reach(grid.end(), TRIED)?;
                carried_on(trial.effort().steps, reached, grid.end())
            }
            Path::ClosedForm | Path::LagrangeTop | Path::MomentumBrake | Path::AxialTorque => (0, false),
        };
        Ok(Cost { samples: grid.len(), steps, is_estimate })
    }
}

/// Steps until `end`, s, if those until `reached` go on so, and whether that is an estimate.
#[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an estimate")]
fn carried_on(steps: u64, reached: f64, end: f64) -> (u64, bool) {
    if reached < end { ((steps as f64 * (end / reached)) as u64, true) } else { (steps, false) }
}

/// Steps of a method that takes equal ones, `longest` at most, from sample to sample.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the plan bounds the steps of a run")]
fn equal_steps(grid: &Grid, longest: f64) -> u64 {
    // As the method counts: 0.3 / 0.1 is a little less than 3.
    let between = |interval: f64| (interval / longest * (1.0 - 4.0 * f64::EPSILON)).ceil().max(1.0) as u64;
    match grid {
        Grid::Uniform { every_s, count } => count.saturating_sub(1) * between(*every_s),
        Grid::List(times) => {
            let first = times.first().copied().filter(|time| *time > 0.0).map_or(0, between);
            first + times.windows(2).map(|pair| between(pair[1] - pair[0])).sum::<u64>()
        }
    }
}
