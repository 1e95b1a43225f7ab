use super::crossing::evenly;
use crate::propagation::PropagationError;
use crate::scenario::Watched;
use crate::telemetry::Channel;

/// The largest magnitude of a drift channel at a thousand times over `duration`, as a fraction.
pub fn largest(watched: Watched<'_>, channel: Channel, duration: f64) -> Result<f64, PropagationError> {
    let samples = watched.sample(&[channel], &evenly(0.0, duration, 1000))?;
    // A NaN must fail the check, and `max` would hide it.
    let largest = |worst: f64, drift: &f64| if drift.is_nan() { f64::NAN } else { worst.max(drift.abs()) };
    Ok(samples.columns()[0].iter().fold(0.0, largest) * 1e-15)
}

/// The largest change of a component since t = 0, at a thousand times over `duration`, relative to its largest magnitude.
pub fn largest_change(
    watched: Watched<'_>,
    (channel, component): (Channel, usize),
    duration: f64,
) -> Result<f64, PropagationError> {
    let samples = watched.sample(&[channel], &evenly(0.0, duration, 1000))?;
    let column = &samples.columns()[component];
    let largest = |value: &dyn Fn(f64) -> f64| {
        // A NaN must fail the check, and `max` would hide it.
        column.iter().fold(0.0, |worst: f64, one| if one.is_nan() { f64::NAN } else { worst.max(value(*one).abs()) })
    };
    let (change, size) = (largest(&|value| value - column[0]), largest(&|value| value));
    Ok(if change == 0.0 { 0.0 } else { change / size })
}
