use super::PlannedBody;
use super::watched::watched;
use crate::propagation::{Effort, PropagationError, Propagator, States};
use crate::telemetry::{BodySamples, Derivation, PointDerivation};

/// Bodies on their way: at whatever times are asked for, ascending, all that is recorded of them and of their points.
pub struct Following {
    bodies: Vec<FollowedBody>,
}

struct FollowedBody {
    propagator: Box<dyn Propagator>,
    states: States,
    derivation: Derivation,
    points: Vec<PointDerivation>,
}

impl Following {
    /// Of these bodies, at t = 0.
    ///
    /// # Errors
    /// If a path does not cover its body's problem.
    pub fn new(bodies: &[PlannedBody]) -> Result<Self, PropagationError> {
        Ok(Self { bodies: bodies.iter().map(FollowedBody::new).collect::<Result<_, _>>()? })
    }

    /// Empty columns for what is recorded of `bodies`, in the order of [`Plan::watched`](super::Plan::watched).
    #[must_use]
    pub fn samples(bodies: &[PlannedBody]) -> Vec<BodySamples> {
        watched(bodies).map(|watched| BodySamples::new(watched.channels())).collect()
    }

    /// Goes to `times`, s, not before those of the last call, and fills [`Self::samples`] of the same bodies.
    ///
    /// # Errors
    /// If a state ceases to be finite or a step cannot be made small enough.
    pub fn fill(&mut self, times: &[f64], samples: &mut [BodySamples]) -> Result<(), PropagationError> {
        let (of_bodies, of_points) = samples.split_at_mut(self.bodies.len());
        for (body, samples) in self.bodies.iter_mut().zip(of_bodies) {
            body.propagator.fill(times, &mut body.states)?;
            body.derivation.derive(times, &body.states, samples);
        }
        let points = self.bodies.iter().flat_map(|body| body.points.iter().map(|point| (&body.states, point)));
        for ((states, point), samples) in points.zip(of_points) {
            point.derive(times, states, samples);
        }
        Ok(())
    }

    /// What the propagation has cost so far, all bodies together.
    #[must_use]
    pub fn effort(&self) -> Effort {
        self.bodies.iter().map(|body| body.propagator.effort()).fold(Effort::default(), |sum, effort| sum + effort)
    }
}

impl FollowedBody {
    fn new(body: &PlannedBody) -> Result<Self, PropagationError> {
        Ok(Self {
            propagator: body.propagator()?,
            states: States::default(),
            derivation: body.derivation(),
            points: body.points.iter().map(|point| PointDerivation::new(&body.problem, point)).collect(),
        })
    }
}
