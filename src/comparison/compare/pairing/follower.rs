use crate::propagation::PropagationError;
use crate::scenario::{Following, PlannedBody};
use crate::telemetry::Samples;

/// Bodies of a scene at whatever times are asked for, ascending.
pub(in crate::comparison) struct Follower {
    bodies: Following,
    samples: Samples,
}

impl Follower {
    /// Of these bodies, with the channels to be told of each and of its points.
    pub fn new(bodies: &[PlannedBody]) -> Result<Self, PropagationError> {
        let samples = Samples { bodies: Following::samples(bodies), ..Samples::default() };
        Ok(Self { bodies: Following::new(bodies)?, samples })
    }

    /// Goes to `times_s`.
    pub fn fill(&mut self, times_s: impl Iterator<Item = f64>) -> Result<(), PropagationError> {
        self.samples.times_s.clear();
        self.samples.times_s.extend(times_s);
        self.bodies.fill(&self.samples.times_s, &mut self.samples.bodies)
    }

    pub fn samples(&self) -> &Samples {
        &self.samples
    }
}
