use std::f64::consts::TAU;

use nalgebra::{Quaternion, UnitQuaternion};

use super::crossing::flips;
use crate::dynamics::momentum_in_world;
use crate::propagation::PropagationError;
use crate::scenario::PlannedBody;
use crate::telemetry::Channel;

/// Angle, rad, turned about L between a sign change of ω along the middle principal axis and the next but one: the period
/// of ω in the body `[Montgomery91]`. Whole turns are taken off so that it is near `expected`; NaN if ω does not come round.
pub fn phase(body: &PlannedBody, period: f64, expected: f64) -> Result<f64, PropagationError> {
    let Some(times) = flips(body, period)? else { return Ok(f64::NAN) };
    let samples = body.sample(&[Channel::Attitude], &times)?;
    let [w, x, y, z] = samples.columns() else { return Ok(f64::NAN) };
    let attitude =
        |index: usize| UnitQuaternion::new_unchecked(Quaternion::new(w[index], x[index], y[index], z[index]));
    let turned = attitude(1) * attitude(0).inverse();
    let momentum = momentum_in_world(body.problem.moments, &body.problem.initial);
    let angle = 2.0 * libm::atan2(turned.imag().dot(&momentum) / momentum.norm(), turned.w);
    Ok(angle + TAU * ((expected - angle) / TAU).round())
}
