use super::crossing::evenly;
use crate::propagation::PropagationError;
use crate::scenario::{Extremum, Watched};
use crate::telemetry::Channel;

/// Times of the first look.
const LOOKS: usize = 2048;
/// Times of each look about the best.
const CLOSE_LOOKS: usize = 64;

/// The least or greatest value between two times, s.
pub fn within(
    watched: Watched<'_>,
    (channel, component): (Channel, usize),
    extremum: Extremum,
    (from, to): (f64, f64),
) -> Result<f64, PropagationError> {
    let is_better = |one: f64, other: f64| match extremum {
        Extremum::Least => one < other,
        Extremum::Greatest => one > other,
    };
    let mut times = evenly(from, to, LOOKS);
    let mut best = f64::NAN;
    // An extremum is flat: its value is known to rounding once its time is to 1e-8 of what it turns in.
    for _ in 0..6 {
        let samples = watched.sample(&[channel], &times)?;
        let values = &samples.columns()[component];
        let mut at = 0;
        for (index, value) in values.iter().enumerate() {
            if is_better(*value, values[at]) {
                at = index;
            }
        }
        best = values[at];
        times = evenly(times[at.saturating_sub(1)], times[(at + 1).min(times.len() - 1)], CLOSE_LOOKS);
    }
    Ok(best)
}
