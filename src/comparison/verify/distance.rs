use std::f64::consts::PI;

use nalgebra::Vector3;

use super::rotation::log;
use super::series::Series;
use super::subject::{Subject, state};
use crate::comparison::{Growth, Trace};
use crate::numerics::so3;
use crate::scenario::ScenarioError;

/// How far the recorded attitudes are from the exact motion through the first state.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    /// The largest angle, rad.
    pub worst_rad: f64,
    /// When that is, s.
    pub worst_at_s: f64,
    /// What the rounding of the first state leaves open there, rad.
    pub open_rad: f64,
    /// The angle at the last sample, rad.
    pub last_rad: f64,
    /// When the angle is first above the tolerance and what the first state leaves open, s.
    pub leaves_at_s: Option<f64>,
    /// How it grows.
    pub growth: Option<Growth>,
}

/// A first state in f64 is looked at no closer than this, rad and relative.
const LEAST_DOUBT: f64 = 1e-14;

impl Distance {
    pub(super) fn of(subject: &Subject, series: &Series, tolerance_rad: f64) -> Result<Self, ScenarioError> {
        let (q, omega) = (subject.attitude[0], subject.omega[0]);
        let exact = subject.trajectory(subject.state(0), &series.times)?;
        let mut open = vec![0.0; series.len()];
        let (tilt, rate) = (series.attitude_doubt.max(LEAST_DOUBT), series.omega_doubt.max(LEAST_DOUBT * omega.norm()));
        for axis in 0..3 {
            let unit = Vector3::ith(axis, 1.0);
            for other in [state(q * so3::exp(&(unit * tilt)), omega), state(q, omega + unit * rate)] {
                for (open, (one, other)) in
                    open.iter_mut().zip(exact.iter().zip(subject.trajectory(other, &series.times)?))
                {
                    *open += log(&(one.0.inverse() * other.0)).norm();
                }
            }
        }
        let angles: Vec<f64> = exact
            .iter()
            .zip(&subject.attitude)
            .map(|((exact, _), found)| log(&(exact.inverse() * found)).norm())
            .collect();
        let mut worst = 0;
        for (k, angle) in angles.iter().enumerate() {
            if *angle > angles[worst] {
                worst = k;
            }
        }
        let leaves = (0..angles.len()).find(|k| angles[*k] > tolerance_rad + open[*k]);
        Ok(Self {
            worst_rad: angles[worst],
            worst_at_s: series.times[worst],
            open_rad: open[worst],
            last_rad: angles.last().copied().unwrap_or(0.0),
            leaves_at_s: leaves.map(|k| series.times[k]),
            growth: growth(&series.times, &angles, &open),
        })
    }
}

/// The law of the angle where it is above what the first state leaves open.
fn growth(times: &[f64], angles: &[f64], open: &[f64]) -> Option<Growth> {
    let start = *times.first()?;
    let mut trace = Trace::default();
    for k in (1..angles.len()).filter(|k| angles[*k] > 10.0 * open[*k]) {
        trace.push(times[k] - start, angles[k]);
    }
    Growth::of(&trace, PI)
}
