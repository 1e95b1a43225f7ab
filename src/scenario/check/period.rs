use super::crossing::{evenly, narrowed, sign_changes};
use crate::propagation::PropagationError;
use crate::scenario::Watched;
use crate::telemetry::Channel;

/// Times at which a period is looked through for crossings.
const LOOKS: usize = 512;

/// Mean time between `cycles` + 1 upward crossings of `level`, s; NaN if they do not come in time.
pub fn mean(
    watched: Watched<'_>,
    (channel, component): (Channel, usize),
    level: f64,
    cycles: u16,
    expected: f64,
) -> Result<f64, PropagationError> {
    // Of an angle that comes round, the sine crosses zero where the angle does, and does not jump.
    let above = |value: f64| if channel.comes_round() { libm::sin(value - level) } else { value - level };
    let values = |times: &[f64]| -> Result<Vec<f64>, PropagationError> {
        let samples = watched.sample(&[channel], times)?;
        Ok(samples.columns()[component].iter().map(|value| above(*value)).collect())
    };
    // Two more: one that may begin at once, and room for a period that is longer than expected.
    let looked = f64::from(cycles) + 2.2;
    let times = evenly(0.0, looked * expected, LOOKS * (usize::from(cycles) + 2));
    let mut changes = sign_changes(&times, &values)?;
    // Up and down in turn, from the first upward: of those alone, each round would meet a change between two of them.
    let starts = values(&changes.iter().map(|(from, _)| *from).collect::<Vec<_>>())?;
    let Some(first) = starts.iter().position(|value| *value < 0.0) else { return Ok(f64::NAN) };
    changes.drain(..first);
    let last = 2 * usize::from(cycles);
    changes.truncate(last + 1);
    if changes.len() <= last {
        return Ok(f64::NAN);
    }
    let times = narrowed(changes, &values)?;
    Ok((times[last] - times[0]) / f64::from(cycles))
}
