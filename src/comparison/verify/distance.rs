use nalgebra::Vector3;

use super::rotation::log;
use super::series::Series;
use super::subject::{Subject, state};
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

/// The law by which an error grows, as far as it is small.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Growth {
    /// As tᵖ.
    Power {
        /// p.
        exponent: f64,
    },
    /// As exp(t/τ).
    Exponential {
        /// τ, s.
        time_s: f64,
    },
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

/// The law that fits better where the angle is above what the first state leaves open and still small.
fn growth(times: &[f64], angles: &[f64], open: &[f64]) -> Option<Growth> {
    const SMALL: f64 = 0.5;
    let until = angles.iter().position(|angle| *angle > SMALL).unwrap_or(angles.len());
    let start = *times.first()?;
    let points: Vec<(f64, f64)> =
        (1..until).filter(|k| angles[*k] > 10.0 * open[*k]).map(|k| (times[k] - start, libm::log(angles[k]))).collect();
    // From a tenth of the span on at least: over less, all laws look alike.
    let (first, last) = (points.first()?.0, points.last()?.0);
    if points.len() < 16 || first * 8.0 > last {
        return None;
    }
    let (exponent, power_miss) = line(points.iter().map(|(t, y)| (libm::log(*t), *y)));
    let (per_second, exponential_miss) = line(points.iter().copied());
    if exponential_miss < 0.5 * power_miss && per_second > 0.0 {
        return Some(Growth::Exponential { time_s: 1.0 / per_second });
    }
    Some(Growth::Power { exponent })
}

/// Slope and mean square miss of the straight line that fits best.
fn line(points: impl Iterator<Item = (f64, f64)> + Clone) -> (f64, f64) {
    let (n, sx, sy) = points.clone().fold((0.0, 0.0, 0.0), |(n, sx, sy), (x, y)| (n + 1.0, sx + x, sy + y));
    let (mx, my) = (sx / n, sy / n);
    let (xx, xy) =
        points.clone().fold((0.0, 0.0), |(xx, xy), (x, y)| (xx + (x - mx) * (x - mx), xy + (x - mx) * (y - my)));
    let slope = xy / xx;
    let miss = points.map(|(x, y)| libm::pow(y - my - slope * (x - mx), 2.0)).sum::<f64>() / n;
    (slope, miss)
}
