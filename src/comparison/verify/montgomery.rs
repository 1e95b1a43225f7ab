use nalgebra::{UnitQuaternion, Vector3};

use super::interpolation::Stencil;
use super::rotation::log;
use super::series::{Series, count_of};
use super::subject::Subject;
use crate::numerics::so3;
use crate::propagation::FreeRotation;
use crate::scenario::ScenarioError;

/// The turn about L in a period of ω, against 2ET/|L| − Ω, Ω the solid angle that L goes round in the body
/// `[Montgomery91]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Montgomery {
    /// T, s: of ω in the body.
    pub period_s: f64,
    /// How many whole periods were looked at.
    pub periods: usize,
    /// The turn about L in a period that the law gives for the first state, rad, −π to π.
    pub due_rad: f64,
    /// The largest difference of the turns recorded from it, rad.
    pub worst_rad: f64,
    /// What rounding and interpolation leave of that in doubt, rad.
    pub floor_rad: f64,
}

/// Periods looked at.
const MOST_PERIODS: usize = 200;

impl Montgomery {
    /// Of free motion with attitudes; `None` where ω does not come round within the file.
    pub(super) fn of(subject: &Subject, series: &Series) -> Result<Option<Self>, ScenarioError> {
        let mut problem = subject.problem().clone();
        problem.initial = subject.state(0);
        let Some(reversals) = FreeRotation::reversals(&problem)? else { return Ok(None) };
        let (period, start) = (2.0 * reversals.interval, series.times[0]);
        let end = series.times[series.len() - 1];
        if !(period.is_finite() && start + period <= end) {
            return Ok(None);
        }
        let momentum = subject.momentum(0).normalize();
        let due = due(subject, start, period)?;
        let mut found = Self { period_s: period, periods: 0, due_rad: due, worst_rad: 0.0, floor_rad: 0.0 };
        let mut before = subject.attitude[0];
        let mut time = start + period;
        while time <= end && found.periods < MOST_PERIODS {
            let (after, lost) = at(subject, series, time);
            let turn = about(&momentum, &(after * before.inverse()));
            let off = turn - due;
            let off = off - std::f64::consts::TAU * (off / std::f64::consts::TAU).round();
            found.worst_rad = found.worst_rad.max(off.abs());
            found.floor_rad = found.floor_rad.max(2.0 * lost + 4.0 * series.attitude_doubt);
            found.periods += 1;
            before = after;
            // By multiplication: a sum would round at each.
            time = start + count_of(found.periods + 1) * period;
        }
        Ok(Some(found))
    }
}

/// 2ET/|L| − Ω of the first state's motion, rad, −π to π.
///
/// Ω is ∮ (1 − cos θ) dφ about the axis that L goes round in the body, by the trapezium: of a periodic function it is
/// right to rounding once the curve is resolved.
fn due(subject: &Subject, start: f64, period: f64) -> Result<f64, ScenarioError> {
    const POINTS: usize = 8192;
    let times: Vec<f64> = (0..POINTS).map(|k| start + period * (count_of(k) / count_of(POINTS))).collect();
    let moments = subject.problem().moments.vector();
    let exact = subject.trajectory(subject.state(0), &times)?;
    let curve: Vec<_> = exact.iter().map(|(_, omega)| (moments.component_mul(omega).normalize(), *omega)).collect();
    // L never crosses the plane across the axis that it goes round.
    let stays = |axis: &usize| curve.iter().map(|(u, _)| u[*axis].abs()).fold(f64::INFINITY, f64::min);
    let mut axes = [0, 1, 2];
    axes.sort_by(|one, other| stays(other).total_cmp(&stays(one)));
    let sign = curve[0].0[axes[0]].signum();
    let solid_angle: f64 =
        curve.iter().map(|(u, omega)| swept(u, omega, axes[0], sign)).sum::<f64>() * period / count_of(POINTS);
    let (energy, momentum) = (subject.energy(0), subject.momentum(0).norm());
    let turn = 2.0 * energy * period / momentum - solid_angle;
    Ok(turn - std::f64::consts::TAU * (turn / std::f64::consts::TAU).round())
}

/// (1 − cos θ) dφ/dt = (x ẏ − y ẋ)/(1 + z) of a direction that is fixed in the world, seen from axes that turn at ω; z
/// along `sign` times the axis.
fn swept(direction: &Vector3<f64>, omega: &Vector3<f64>, axis: usize, sign: f64) -> f64 {
    let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
    let rate = direction.cross(omega);
    sign * (direction[x] * rate[y] - direction[y] * rate[x]) / (1.0 + sign * direction[axis])
}

/// The angle of the turn about `axis` that comes nearest to a rotation, rad.
fn about(axis: &Vector3<f64>, rotation: &UnitQuaternion<f64>) -> f64 {
    let angle = 2.0 * libm::atan2(rotation.imag().dot(axis), rotation.w);
    angle - std::f64::consts::TAU * (angle / std::f64::consts::TAU).round()
}

/// The attitude at a time between samples, and how far it may be off, rad.
fn at(subject: &Subject, series: &Series, time: f64) -> (UnitQuaternion<f64>, f64) {
    let times = &series.times;
    let near = times.partition_point(|own| *own <= time).clamp(1, times.len() - 1) - 1;
    let by = |width: usize| {
        let first = (near + 1).saturating_sub(width / 2).min(times.len() - width.min(times.len()));
        let span = first..(first + width).min(times.len());
        let base = subject.attitude[near];
        let vectors: Vec<_> = subject.attitude[span.clone()].iter().map(|q| log(&(base.inverse() * q))).collect();
        Stencil::between(&times[span], 0, width).vector(&vectors, time)
    };
    let (fine, coarse) = (by(8), by(6));
    (subject.attitude[near] * so3::exp(&fine), (fine - coarse).norm())
}
