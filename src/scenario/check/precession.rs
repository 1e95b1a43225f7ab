use std::f64::consts::{PI, TAU};

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::crossing::evenly;
use crate::body::State;
use crate::propagation::PropagationError;
use crate::scenario::PlannedBody;
use crate::telemetry::Channel;

/// Mean rate, rad/s, at which `axis` (body axes) goes round `around` (world axes; L at t = 0 where left out).
pub fn in_world(
    body: &PlannedBody,
    axis: &Vector3<f64>,
    around: Option<&Vector3<f64>>,
    duration: f64,
    expected: f64,
) -> Result<f64, PropagationError> {
    let around = around.copied().unwrap_or_else(|| initial_momentum(body));
    let times = evenly(0.0, duration, looks(duration, expected));
    let samples = body.sample(&[Channel::Attitude], &times)?;
    let [w, x, y, z] = samples.columns() else { return Ok(f64::NAN) };
    let directions = (0..times.len())
        .map(|index| UnitQuaternion::new_unchecked(Quaternion::new(w[index], x[index], y[index], z[index])) * axis);
    Ok(mean_rate(directions, &around, duration))
}

/// Mean rate, rad/s, at which ω goes round `axis`, both in body axes.
pub fn in_body(body: &PlannedBody, axis: &Vector3<f64>, duration: f64, expected: f64) -> Result<f64, PropagationError> {
    let times = evenly(0.0, duration, looks(duration, expected));
    let samples = body.sample(&[Channel::AngularVelocity], &times)?;
    let columns = samples.columns();
    let directions = (0..times.len()).map(|index| Vector3::from_fn(|row, _| columns[row][index]));
    Ok(mean_rate(directions, axis, duration))
}

fn initial_momentum(body: &PlannedBody) -> Vector3<f64> {
    let initial: &State = &body.problem.initial;
    body.problem.momentum_in_world(0.0, initial)
}

/// How many times to look: sixteen a turn at the expected rate, so that no turn is missed.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
pub fn looks(duration: f64, expected: f64) -> usize {
    (duration * expected.abs() / TAU * 16.0).clamp(256.0, 1e6) as usize
}

/// Angle gone round `around`, unwrapped, over `duration`.
fn mean_rate(directions: impl Iterator<Item = Vector3<f64>>, around: &Vector3<f64>, duration: f64) -> f64 {
    let Some(pole) = around.try_normalize(0.0) else { return f64::NAN };
    let least = pole.iamin();
    let Some(first) = pole.cross(&Vector3::ith(least, 1.0)).try_normalize(0.0) else { return f64::NAN };
    let second = pole.cross(&first);
    unwrapped(directions.map(|direction| libm::atan2(direction.dot(&second), direction.dot(&first)))) / duration
}

/// From the first of these angles, −π to π, to the last, none more than half a turn from the one before it.
pub fn unwrapped(mut angles: impl Iterator<Item = f64>) -> f64 {
    let Some(start) = angles.next() else { return f64::NAN };
    // Whole turns are counted, not added up: a sum of thousands of angles would round as often.
    let (mut turns, mut last) = (0.0, start);
    for angle in angles {
        turns -= ((angle - last + PI) / TAU).floor();
        last = angle;
    }
    TAU * turns + (last - start)
}
