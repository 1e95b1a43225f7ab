use nalgebra::{UnitQuaternion, Vector3};

use super::Reading;
use super::interpolation::Stencil;
use super::rotation::log;
use crate::recording::{Axes, Observed, Track};

/// Attitude and ω in body axes at the same times, under one reading of the file.
#[derive(Debug, Clone)]
pub struct Series {
    /// s, ascending.
    pub times: Vec<f64>,
    /// World from body, unit, each with the sign that is nearer to the one before; empty where none was recorded.
    pub attitude: Vec<UnitQuaternion<f64>>,
    /// Body axes, rad/s.
    pub omega: Vec<Vector3<f64>>,
    /// How far an attitude may be from what the program had, rad.
    pub attitude_doubt: f64,
    /// The same of ω, rad/s.
    pub omega_doubt: f64,
    /// Whether ω was found from the attitudes.
    pub is_derived: bool,
}

/// Roundings of what the file keeps that add up to the doubt of an attitude: four components, and the norm.
const ATTITUDE_ROUNDINGS: f64 = 4.0;
/// The same of ω: three components, and the turn into body axes.
const OMEGA_ROUNDINGS: f64 = 3.0;
/// Neighbours on each side from whose attitudes ω is found.
const SIDE: usize = 3;

impl Series {
    /// The samples `used` of a file; `None` where they are not numbers, or ω cannot be read without an attitude.
    pub fn read(observed: &Observed, used: &[usize], reading: &Reading) -> Option<Self> {
        let Some(attitude) = &observed.attitude else {
            return Self::rates_only(observed.angular_velocity.as_ref()?, used, reading);
        };
        let within = |index: &usize| match &observed.angular_velocity {
            Some(rates) => {
                let time = attitude.times_s[*index];
                rates.times_s.first().is_some_and(|first| *first <= time)
                    && rates.times_s.last().is_some_and(|last| time <= *last)
            }
            None => true,
        };
        let used: Vec<usize> = used.iter().copied().filter(within).collect();
        let times: Vec<f64> = used.iter().map(|index| attitude.times_s[*index]).collect();
        let mut turned: Vec<UnitQuaternion<f64>> = Vec::with_capacity(used.len());
        for index in &used {
            let q = reading.attitude(attitude.columns.each_ref().map(|column| column[*index]))?;
            let flips = turned.last().is_some_and(|last| last.coords.dot(&q.coords) < 0.0);
            turned.push(if flips { UnitQuaternion::new_unchecked(-q.into_inner()) } else { q });
        }
        let attitude_doubt = ATTITUDE_ROUNDINGS * resolution(attitude);
        let Some(rates) = &observed.angular_velocity else {
            return Some(Self::derived(&times, &turned, attitude_doubt));
        };
        let (columns, lost) = at_times(rates, attitude, &used, &times);
        let omega: Vec<_> = columns.iter().zip(&turned).map(|(rate, q)| reading.rate((*rate).into(), q)).collect();
        if omega.iter().any(|rate| !rate.iter().all(|component| component.is_finite())) {
            return None;
        }
        let mut doubt = resolution(rates);
        if reading.axes == Axes::World {
            doubt += attitude_doubt;
        }
        let omega_doubt = OMEGA_ROUNDINGS * doubt * largest(&omega) + lost * reading.rate_factor;
        Some(Self { times, attitude: turned, omega, attitude_doubt, omega_doubt, is_derived: false })
    }

    /// With ω from the attitudes, and without the ends, where a slope has neighbours on one side only.
    fn derived(times: &[f64], attitude: &[UnitQuaternion<f64>], attitude_doubt: f64) -> Self {
        let (omega, omega_doubt) = from_attitudes(times, attitude, attitude_doubt);
        let ends = if times.len() > 6 * SIDE { SIDE } else { 0 };
        let kept = ends..times.len() - ends;
        Self {
            times: times[kept.clone()].to_vec(),
            attitude: attitude[kept.clone()].to_vec(),
            omega: omega[kept].to_vec(),
            attitude_doubt,
            omega_doubt,
            is_derived: true,
        }
    }

    fn rates_only(rates: &Track<3>, used: &[usize], reading: &Reading) -> Option<Self> {
        if reading.axes == Axes::World {
            return None;
        }
        let at = |index: &usize| Vector3::from(rates.columns.each_ref().map(|column| column[*index]));
        let omega: Vec<_> = used.iter().map(|index| at(index) * reading.rate_factor).collect();
        if omega.iter().any(|rate| !rate.iter().all(|component| component.is_finite())) {
            return None;
        }
        Some(Self {
            times: used.iter().map(|index| rates.times_s[*index]).collect(),
            attitude: Vec::new(),
            omega_doubt: OMEGA_ROUNDINGS * resolution(rates) * largest(&omega),
            omega,
            attitude_doubt: 0.0,
            is_derived: false,
        })
    }

    /// How many samples.
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// From the first sample to the last, s.
    pub fn span(&self) -> f64 {
        self.times[self.len() - 1] - self.times[0]
    }

    /// Root of the mean square of ω, rad/s.
    pub fn rate(&self) -> f64 {
        rms(self.omega.iter().map(Vector3::norm))
    }

    /// The angle through which the body turns over the whole, rad: ∫|ω| dt.
    pub fn angle(&self) -> f64 {
        let mean = |k: usize| 0.5 * (self.omega[k].norm() + self.omega[k - 1].norm());
        (1..self.len()).map(|k| mean(k) * (self.times[k] - self.times[k - 1])).sum()
    }

    /// How many samples there are to a turn, where it turns fastest but for one sample in ten.
    pub fn samples_per_turn(&self) -> f64 {
        let mut steps: Vec<f64> =
            (1..self.len()).map(|k| self.omega[k].norm() * (self.times[k] - self.times[k - 1])).collect();
        steps.sort_by(f64::total_cmp);
        let step = steps.get(steps.len() * 9 / 10).copied().unwrap_or(0.0);
        std::f64::consts::TAU / step
    }
}

/// Half a unit in the last place, relative; that of f32 where every number is one.
pub(super) fn resolution<const N: usize>(track: &Track<N>) -> f64 {
    const SINGLE: f64 = 1.0 / (1 << 24) as f64;
    if is_single(track) { track.resolution.max(SINGLE) } else { track.resolution }
}

/// Whether every number is an f32.
pub(super) fn is_single<const N: usize>(track: &Track<N>) -> bool {
    #[expect(clippy::cast_possible_truncation, reason = "whether it is an f32 is the question")]
    let is_single = |value: &f64| f64::from(*value as f32).to_bits() == value.to_bits();
    // Zeros and ones are f32's in any file.
    let varies = track.columns.iter().flatten().any(|value| *value != value.round());
    varies && track.columns.iter().flatten().all(is_single)
}

/// As a number.
#[expect(clippy::cast_precision_loss, reason = "no file has 2⁵³ samples")]
pub(super) fn count_of(samples: usize) -> f64 {
    samples as f64
}

/// Root of the mean square.
pub(super) fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (count, sum) = values.fold((0.0_f64, 0.0), |(count, sum), value| (count + 1.0, sum + value * value));
    (sum / count.max(1.0)).sqrt()
}

fn largest(vectors: &[Vector3<f64>]) -> f64 {
    vectors.iter().map(Vector3::norm).fold(0.0, f64::max)
}

/// ω as it stands at the times of the attitudes, and what is lost by interpolating it there if it has times of its own.
fn at_times(rates: &Track<3>, attitude: &Track<4>, used: &[usize], times: &[f64]) -> (Vec<Vector3<f64>>, f64) {
    let row = |index: usize| Vector3::from(rates.columns.each_ref().map(|column| column[index]));
    if rates.times_s == attitude.times_s {
        return (used.iter().map(|index| row(*index)).collect(), 0.0);
    }
    let values: Vec<_> = (0..rates.times_s.len()).map(row).collect();
    let mut lost = 0.0_f64;
    let found = times.iter().map(|time| {
        let next = rates.times_s.partition_point(|own| own <= time);
        let k = next.saturating_sub(1);
        let fine = Stencil::between(&rates.times_s, k, 6).vector(&values, *time);
        lost = lost.max((fine - Stencil::between(&rates.times_s, k, 4).vector(&values, *time)).norm());
        fine
    });
    (found.collect(), lost)
}

/// ω as the slope of the rotation vector from each attitude to its neighbours, and the doubt of it, rad/s.
fn from_attitudes(times: &[f64], attitude: &[UnitQuaternion<f64>], doubt: f64) -> (Vec<Vector3<f64>>, f64) {
    let slope = |k: usize, width: usize| {
        let width = width.min(times.len());
        let first = k.saturating_sub(width / 2).min(times.len() - width);
        let near = &times[first..first + width];
        let vectors: Vec<_> = (first..first + width).map(|j| log(&(attitude[k].inverse() * attitude[j]))).collect();
        Stencil::between(near, 0, width).slope(&vectors, k - first)
    };
    let fine: Vec<_> = (0..times.len()).map(|k| slope(k, 2 * SIDE + 1)).collect();
    // The ends have their neighbours on one side, and are worse: the middle tells what most of the samples have.
    let mut lost: Vec<f64> = (0..times.len()).map(|k| (fine[k] - slope(k, 2 * SIDE - 1)).norm()).collect();
    lost.sort_by(f64::total_cmp);
    let lost = lost.get(lost.len() * 9 / 10).copied().unwrap_or(0.0);
    let shortest = times.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    (fine, lost + 2.0 * doubt / shortest)
}
