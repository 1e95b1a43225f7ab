use super::crossing::evenly;
use super::precession::{looks, unwrapped};
use crate::propagation::PropagationError;
use crate::scenario::Watched;
use crate::telemetry::Channel;

/// Mean rate, rad/s, of an angle that comes round.
pub fn mean(
    watched: Watched<'_>,
    (channel, component): (Channel, usize),
    duration: f64,
    expected: f64,
) -> Result<f64, PropagationError> {
    // Four times as often as a steady angle needs: nutation makes it uneven.
    let times = evenly(0.0, duration, looks(duration, 4.0 * expected));
    let samples = watched.sample(&[channel], &times)?;
    Ok(unwrapped(samples.columns()[component].iter().copied()) / duration)
}
