use crate::propagation::PropagationError;
use crate::scenario::PlannedBody;
use crate::telemetry::Channel;

/// What a component of a channel reads at `time`.
pub fn at(body: &PlannedBody, channel: Channel, component: usize, time: f64) -> Result<f64, PropagationError> {
    let samples = body.sample(&[channel], &[time])?;
    Ok(samples.columns()[component][0])
}
