use crate::propagation::{PropagationError, Propagator, States};
use crate::scenario::PlannedBody;
use crate::telemetry::{BodySamples, Channel, Derivation, Samples};

/// Bodies of a scene at whatever times are asked for, ascending.
pub(in crate::comparison) struct Follower {
    bodies: Vec<FollowingBody>,
    samples: Samples,
}

struct FollowingBody {
    propagator: Box<dyn Propagator>,
    states: States,
    derivation: Derivation,
}

impl Follower {
    /// Of each body with the channels to be told of it.
    pub fn new(bodies: &[(&PlannedBody, Vec<Channel>)]) -> Result<Self, PropagationError> {
        let samples = bodies.iter().map(|(_, channels)| BodySamples::new(channels)).collect();
        let body = |(body, channels): &(&PlannedBody, Vec<Channel>)| {
            let body = (*body).clone().watching(channels);
            let derivation = Derivation::new(&body.problem, body.properties.body_from_principal);
            Ok(FollowingBody { propagator: body.propagator()?, states: States::default(), derivation })
        };
        let bodies = bodies.iter().map(body).collect::<Result<_, _>>()?;
        Ok(Self { bodies, samples: Samples { bodies: samples, ..Samples::default() } })
    }

    /// Goes to `times_s`.
    pub fn fill(&mut self, times_s: impl Iterator<Item = f64>) -> Result<(), PropagationError> {
        self.samples.times_s.clear();
        self.samples.times_s.extend(times_s);
        for (body, samples) in self.bodies.iter_mut().zip(&mut self.samples.bodies) {
            body.propagator.fill(&self.samples.times_s, &mut body.states)?;
            body.derivation.derive(&self.samples.times_s, &body.states, samples);
        }
        Ok(())
    }

    pub fn samples(&self) -> &Samples {
        &self.samples
    }
}
