use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::crossing::evenly;
use crate::propagation::PropagationError;
use crate::scenario::PlannedBody;
use crate::telemetry::Channel;

/// Times at which the axis is looked at.
const LOOKS: usize = 4096;

/// The largest angle, rad, between `axis` (body axes) and `near` (world axes; where the axis points at t = 0 if left out).
pub fn largest_angle(
    body: &PlannedBody,
    axis: &Vector3<f64>,
    near: Option<&Vector3<f64>>,
    duration: f64,
) -> Result<f64, PropagationError> {
    let samples = body.sample(&[Channel::Attitude], &evenly(0.0, duration, LOOKS))?;
    let [w, x, y, z] = samples.columns() else { return Ok(f64::NAN) };
    let pointing =
        |index: usize| UnitQuaternion::new_unchecked(Quaternion::new(w[index], x[index], y[index], z[index])) * axis;
    let near = near.copied().unwrap_or_else(|| pointing(0));
    let angle = |index: usize| {
        let direction = pointing(index);
        libm::atan2(direction.cross(&near).norm(), direction.dot(&near))
    };
    // A NaN must fail the check, and `max` would hide it.
    let worse = |worst: f64, angle: f64| if angle.is_nan() { f64::NAN } else { worst.max(angle) };
    Ok((0..w.len()).map(angle).fold(0.0, worse))
}
