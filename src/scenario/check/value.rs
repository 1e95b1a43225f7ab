use crate::propagation::PropagationError;
use crate::scenario::Watched;
use crate::telemetry::Channel;

/// What a component of a channel reads at `time`.
pub fn at(watched: Watched<'_>, channel: Channel, component: usize, time: f64) -> Result<f64, PropagationError> {
    let samples = watched.sample(&[channel], &[time])?;
    Ok(samples.columns()[component][0])
}
