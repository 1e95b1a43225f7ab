use super::{Following, Plan, PlannedBody};
use crate::propagation::PropagationError;
use crate::telemetry::{BodySamples, Channel, Point};

/// What is recorded under one name: a body, or a point of one.
#[derive(Debug, Clone, Copy)]
pub struct Watched<'a> {
    /// Whose motion it is.
    pub body: &'a PlannedBody,
    /// Of which point of it, if not of the body.
    pub point: Option<&'a Point>,
}

impl Plan {
    /// Everything that is recorded under a name of its own, in the order of recordings: the bodies, then the points of each.
    pub fn watched(&self) -> impl Iterator<Item = Watched<'_>> {
        watched(&self.bodies)
    }
}

/// As [`Plan::watched`].
pub fn watched(bodies: &[PlannedBody]) -> impl Iterator<Item = Watched<'_>> {
    let points = bodies.iter().flat_map(|body| body.points.iter().map(|point| Watched { body, point: Some(point) }));
    bodies.iter().map(Watched::from).chain(points)
}

impl<'a> From<&'a PlannedBody> for Watched<'a> {
    fn from(body: &'a PlannedBody) -> Self {
        Self { body, point: None }
    }
}

impl<'a> Watched<'a> {
    /// Its name, fit for topics and entity paths: of a point, the body's, a slash and its own.
    #[must_use]
    pub fn name(self) -> &'a str {
        self.point.map_or(&self.body.name, |point| &point.name)
    }

    /// What is recorded of it, in the order of [`Channel::ALL`].
    #[must_use]
    pub fn channels(self) -> &'a [Channel] {
        self.point.map_or(&self.body.channels, |point| &point.channels)
    }

    /// What `channels` read at `times` (ascending, s), propagated afresh from t = 0 and nothing else with it.
    ///
    /// # Errors
    /// If the state ceases to be finite or a step cannot be made small enough.
    pub fn sample(self, channels: &[Channel], times: &[f64]) -> Result<BodySamples, PropagationError> {
        let of_body = if self.point.is_some() { &[][..] } else { channels };
        let points = self.point.map(|point| Point { channels: channels.to_vec(), ..point.clone() });
        let body = PlannedBody { points: points.into_iter().collect(), ..self.body.clone() };
        let body = [body.watching(of_body)];
        let mut samples = Following::samples(&body);
        Following::new(&body)?.fill(times, &mut samples)?;
        Ok(samples.pop().unwrap_or_default())
    }
}
