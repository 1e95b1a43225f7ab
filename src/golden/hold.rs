use std::path::Path;

use super::report::{Divergence, Quantity, Report, Row};
use super::{Golden, GoldenError, HoldError, Limits, Pose};
use crate::propagation::attitude_angle;

/// Holds a simulation to the recording at `path`, of its only body: `simulate` is asked for each of its times, s, once and
/// ascending.
///
/// # Errors
/// If the recording cannot be read, or the simulation leaves a limit: the error's text is the report.
pub fn hold(path: impl AsRef<Path>, limits: Limits, simulate: impl FnMut(f64) -> Pose) -> Result<Report, HoldError> {
    Golden::open(path)?.hold(limits, simulate)
}

impl Golden {
    /// Holds a simulation to this motion: `simulate` is asked for each time, s, once and ascending. It is asked to the end,
    /// beyond the first divergence too.
    ///
    /// # Errors
    /// If it leaves a limit: the error's text is the report. If there is nothing to compare with.
    pub fn hold(&self, limits: Limits, mut simulate: impl FnMut(f64) -> Pose) -> Result<Report, HoldError> {
        let tells_rates = self.poses.iter().all(|pose| pose.angular_velocity.is_some());
        if limits.angular_velocity_rad_s.is_some() && !tells_rates {
            return Err(GoldenError::NothingToLimit { golden: self.name.clone() }.into());
        }
        let mut rows = Vec::new();
        let mut first = None;
        let mut off_unit = 0.0_f64;
        let compared = self.times_s.iter().zip(&self.poses).take_while(|(time_s, _)| **time_s <= limits.until_s);
        for (sample, (time_s, expected)) in compared.enumerate() {
            let simulated = simulate(*time_s);
            let row = row(*time_s, expected, &simulated, &limits);
            off_unit = off_unit.max(wrong_if_nan((simulated.length() - 1.0).abs()));
            first = first.or_else(|| {
                let (quantity, difference, limit) = beyond(&row, &limits)?;
                let (time_s, expected) = (*time_s, *expected);
                Some(Divergence { quantity, time_s, sample, expected, simulated, difference, limit })
            });
            rows.push(row);
        }
        if rows.is_empty() {
            return Err(GoldenError::Empty { golden: self.name.clone() }.into());
        }
        let report = Report::new(self.name.clone(), limits, rows, first, off_unit);
        if report.first.is_some() { Err(HoldError::Diverged(Box::new(report))) } else { Ok(report) }
    }
}

/// How far the two are apart.
fn row(time_s: f64, expected: &Pose, simulated: &Pose, limits: &Limits) -> Row {
    let attitude_rad = wrong_if_nan(attitude_angle(expected.unit_wxyz(), simulated.unit_wxyz()));
    // In the axes in which the simulation tells it: its attitude's error is none of the angular velocity's.
    let told = if simulated.is_turning_in_world() {
        (expected.angular_velocity_in_world(), simulated.angular_velocity_in_world())
    } else {
        (expected.angular_velocity_in_body(), simulated.angular_velocity_in_body())
    };
    let angular_velocity_rad_s = match told {
        (Some(a), Some(b)) => Some(wrong_if_nan(libm::hypot(libm::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]))),
        _ if limits.angular_velocity_rad_s.is_some() => Some(f64::INFINITY),
        _ => None,
    };
    Row { time_s, attitude_rad, angular_velocity_rad_s }
}

/// The limit that is left, and by how much.
fn beyond(row: &Row, limits: &Limits) -> Option<(Quantity, f64, f64)> {
    let attitude = limits.attitude_rad.map(|limit| (Quantity::Attitude, row.attitude_rad, limit));
    let rates = limits.angular_velocity_rad_s.zip(row.angular_velocity_rad_s);
    let rates = rates.map(|(limit, difference)| (Quantity::AngularVelocity, difference, limit));
    // A limit that is no number is left by everything.
    attitude.into_iter().chain(rates).find(|(_, difference, limit)| limit.is_nan() || difference > limit)
}

/// NaN is as wrong as can be.
fn wrong_if_nan(difference: f64) -> f64 {
    if difference.is_nan() { f64::INFINITY } else { difference }
}
