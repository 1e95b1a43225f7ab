use super::observe::Observation;
use crate::recording::{Axes, Observed, RecordedBody, Recording, RecordingError, Track};
use crate::telemetry::{BodySamples, Channel};

/// Half a unit in the last place of an f64.
pub(super) const DOUBLE: f64 = f64::EPSILON / 2.0;

/// What a recording of this crate says: of quantities that it tells in both axes, those of the body for ω and the moment,
/// those of the world for L.
///
/// # Errors
/// As [`Recording::next_batch`]; if it has no samples, tells of no body, or holds a number that is not finite.
pub(super) fn observe(recording: &mut Recording) -> Result<Observation, RecordingError> {
    let (mut times, mut samples) = (Vec::new(), recording.heading().samples());
    while let Some(batch) = recording.next_batch()? {
        times.extend_from_slice(&batch.times_s);
        let columns = samples.bodies.iter_mut().flat_map(BodySamples::columns_mut);
        for (column, new) in columns.zip(batch.bodies.iter().flat_map(BodySamples::columns)) {
            column.extend_from_slice(new);
        }
    }
    if times.is_empty() {
        return Err(recording.refuse("it has no samples".into()));
    }
    // A point of a body obeys no law of its own.
    let bodies = recording.heading().bodies.iter().zip(&mut samples.bodies).filter(|(body, _)| !body.is_point());
    let bodies: Vec<_> =
        bodies.map(|(body, samples)| observed(body, samples, &times)).filter(Observed::tells).collect();
    if bodies.is_empty() {
        return Err(
            recording.refuse("none of its channels tells an attitude, ω, L, a moment, a position or a velocity".into())
        );
    }
    if let Some(body) = bodies.iter().find(|body| !body.is_finite()) {
        return Err(recording.refuse(format!("{:?} has a value that is not finite", body.name)));
    }
    Ok(Observation { bodies, ..Observation::default() })
}

fn observed(body: &RecordedBody, samples: &mut BodySamples, times: &[f64]) -> Observed {
    Observed {
        name: body.name.clone(),
        attitude: track(samples, times, &[(Channel::Attitude, None)]),
        angular_velocity: track(
            samples,
            times,
            &[(Channel::AngularVelocity, Some(Axes::Body)), (Channel::AngularVelocityWorld, Some(Axes::World))],
        ),
        angular_momentum: track(
            samples,
            times,
            &[(Channel::AngularMomentumWorld, Some(Axes::World)), (Channel::AngularMomentumBody, Some(Axes::Body))],
        ),
        moment: track(
            samples,
            times,
            &[(Channel::MomentBody, Some(Axes::Body)), (Channel::MomentWorld, Some(Axes::World))],
        ),
        position: track(samples, times, &[(Channel::Position, Some(Axes::World))]),
        velocity: track(samples, times, &[(Channel::Velocity, Some(Axes::World))]),
    }
}

/// The first of `channels` that there is.
fn track<const N: usize>(
    samples: &mut BodySamples,
    times: &[f64],
    channels: &[(Channel, Option<Axes>)],
) -> Option<Track<N>> {
    let (channel, axes) = *channels.iter().find(|(channel, _)| samples.channel(*channel).is_some())?;
    let mut columns = samples.channel_mut(channel)?.iter_mut().map(std::mem::take);
    let columns = std::array::from_fn(|_| columns.next().unwrap_or_default());
    Some(Track { times_s: times.to_vec(), columns, axes, resolution: DOUBLE })
}
