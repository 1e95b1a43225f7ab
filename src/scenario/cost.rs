use super::{Grid, Path, PlannedBody};
use crate::propagation::{PropagationError, States};

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
/// How often a run is halved in search of a part that is short enough.
const HALVINGS: i32 = 60;

impl PlannedBody {
    /// What a run to the end of `grid` costs: asked of a trial of a thousand steps or some more.
    ///
    /// # Errors
    /// If the trial cannot be propagated.
    pub fn cost(&self, grid: &Grid) -> Result<Cost, PropagationError> {
        let (steps, is_estimate) = match self.path {
            Path::FixedStep { step, .. } => (equal_steps(grid, step), false),
            Path::Taylor { .. } | Path::Dop853 { .. } => self.tried(grid.end())?,
            Path::ClosedForm | Path::LagrangeTop | Path::MomentumBrake | Path::AxialTorque => (0, false),
        };
        Ok(Cost { samples: grid.len(), steps, is_estimate })
    }

    /// Steps until `end`, s, and whether that is an estimate.
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an estimate"
    )]
    fn tried(&self, end: f64) -> Result<(u64, bool), PropagationError> {
        let mut propagator = self.propagator()?;
        let mut states = States::default();
        for halvings in (0..=HALVINGS).rev() {
            let time = libm::ldexp(end, -halvings);
            propagator.fill(&[time], &mut states)?;
            let steps = propagator.effort().steps;
            if steps > TRIED && halvings > 0 {
                return Ok((libm::ldexp(steps as f64, halvings) as u64, true));
            }
        }
        Ok((propagator.effort().steps, false))
    }
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
