use super::batch::Batch;
use super::{BodySamples, Channel, Point, PointKind};
use crate::dynamics::Problem;
use crate::propagation::States;

/// Makes the channels of a body's point out of the body's states.
#[derive(Debug, Clone)]
pub struct PointDerivation {
    problem: Problem,
    kind: PointKind,
}

impl PointDerivation {
    /// Of `point`, from states of `problem`.
    #[must_use]
    pub fn new(problem: &Problem, point: &Point) -> Self {
        Self { problem: problem.clone(), kind: point.kind.clone() }
    }

    /// Fills the columns of `samples` from `states` at `times`.
    pub fn derive(&self, times: &[f64], states: &States, samples: &mut BodySamples) {
        let batch = Batch { times, states, initial: &self.problem.initial };
        for channel in Channel::ALL {
            let Some(columns) = samples.channel_mut(channel) else { continue };
            match &self.kind {
                PointKind::Mounted(mounting) => mounting.read(&self.problem, channel, &batch, columns),
            }
        }
    }
}
