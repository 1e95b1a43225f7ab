use nalgebra::{UnitQuaternion, Vector3};

use super::interpolation::Stencil;
use super::rotation::{log, turned, turned_at_once};
use super::series::{Series, count_of, rms};
use super::unexplained::correlation;
use super::update::Update;
use crate::numerics::so3;

/// Does the attitude turn as ω says?
#[derive(Debug, Clone, PartialEq)]
pub struct Kinematics {
    /// Samples to a turn.
    pub samples_per_turn: f64,
    /// Root mean square of the difference between the turn from one sample to the next and that which ω makes, relative.
    pub mismatch: f64,
    /// What rounding in the file and sampling leave of it in doubt.
    pub floor: f64,
    /// By how much later than ω's own times the attitude turns at ω, s: negative where q is behind.
    pub lag: Estimate,
    /// By how much faster than ω says the attitude turns, relative.
    pub excess: Estimate,
    /// Of the differences of neighbouring turns, lag and excess taken off, −1 to 1: −½ where attitudes are noisy.
    pub correlation: f64,
    /// How far integrating ω from the first attitude leads from the last ones at most, rad, the lag taken off.
    pub apart_rad: f64,
    /// What rounding and sampling leave of that in doubt, rad.
    pub apart_floor_rad: f64,
    /// Turns from one sample to the next that are far from what ω and their neighbours say: dropped frames.
    pub jumps: usize,
    /// When the first of those was, s.
    pub first_jump_s: Option<f64>,
    /// The formula by which each attitude follows from the one before, where one holds to rounding.
    pub update: Option<Update>,
}

/// A number found from samples, and how far it may be off.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// How far it may be off.
    pub doubt: f64,
}

impl Estimate {
    /// Whether it is not zero.
    #[must_use]
    pub fn is_seen(&self) -> bool {
        self.value.abs() > self.doubt
    }

    /// Zero, in doubt by what it was.
    fn unseen(self) -> Self {
        Self { value: 0.0, doubt: self.doubt.max(self.value.abs()) }
    }
}

/// A mismatch this many times the middle one is a jump, if those are few.
const JUMP: f64 = 30.0;
/// A shift or a factor that leaves more than this of the difference explains next to nothing, and is none.
const LITTLE: f64 = 0.9;
/// Doubts beyond which something is seen.
pub(super) const CLEAR: f64 = 4.0;

/// Turns between samples, as recorded and as ω makes them, body axes, rad.
pub(super) struct Turns {
    pub recorded: Vec<Vector3<f64>>,
    pub made: Vec<Vector3<f64>>,
    /// What interpolation leaves in doubt of each.
    pub lost: Vec<f64>,
}

impl Turns {
    /// With ω taken `lag` s later than its times say.
    pub fn of(series: &Series, lag: f64) -> Self {
        let (times, omega) = (&series.times, &series.omega);
        let intervals = 0..times.len().saturating_sub(1);
        let recorded = intervals.clone().map(|k| log(&(series.attitude[k].inverse() * series.attitude[k + 1])));
        let both = intervals.map(|k| {
            let span = [times[k] + lag, times[k + 1] + lag];
            let made = turned(&Stencil::between(times, k, 6), omega, span);
            (made, (made - turned_at_once(&Stencil::between(times, k, 4), omega, span)).norm())
        });
        let (made, lost): (Vec<_>, Vec<_>) = both.unzip();
        // The shorter way is not always the way that was gone.
        let recorded = recorded.zip(&made).map(|(short, made)| nearest_way(short, made)).collect();
        Self { recorded, made, lost }
    }

    /// Root mean square of the difference, relative to the turns recorded.
    pub fn mismatch(&self) -> f64 {
        let difference = rms(self.recorded.iter().zip(&self.made).map(|(a, b)| (a - b).norm()));
        difference / rms(self.recorded.iter().map(Vector3::norm)).max(f64::MIN_POSITIVE)
    }
}

/// Of the rotation vectors that turn alike, that which is nearest to `made`.
fn nearest_way(short: Vector3<f64>, made: &Vector3<f64>) -> Vector3<f64> {
    let angle = short.norm();
    if angle == 0.0 {
        return short;
    }
    let along = short.dot(made) / angle;
    let turns = ((along - angle) / std::f64::consts::TAU).round();
    short * (1.0 + turns * std::f64::consts::TAU / angle)
}

impl Kinematics {
    /// Of a series with attitudes and recorded rates; `None` of fewer than four samples.
    pub fn of(series: &Series, rounding_s: f64) -> Option<Self> {
        if series.len() < 4 || series.attitude.is_empty() || series.is_derived {
            return None;
        }
        let plain = Turns::of(series, 0.0);
        let step = |k: usize| series.times[k + 1] - series.times[k];
        let doubt = |k: usize| {
            2.0 * series.attitude_doubt
                + series.omega_doubt * step(k)
                + rounding_s * series.omega[k].norm()
                + plain.lost[k]
        };
        let count = plain.made.len();
        let floors: Vec<f64> = (0..count).map(doubt).collect();
        let angle = rms(plain.recorded.iter().map(Vector3::norm)).max(f64::MIN_POSITIVE);
        let mut kept: Vec<usize> = (0..count).collect();
        let jumps = jumps(series, &plain, &floors);
        kept.retain(|k| !jumps.contains(k));

        let lag = lag(series, &plain, &floors, &kept);
        let shifted = if lag.is_seen() { Turns::of(series, lag.value) } else { plain };
        let mut excess = along(&shifted.recorded, &shifted.made, &shifted.made, &floors, &kept);
        let off = |k: usize, factor: f64| shifted.recorded[k] - shifted.made[k] * factor;
        let left = |factor: f64| rms(kept.iter().map(|k| off(*k, factor).norm()));
        if left(1.0 + excess.value) > LITTLE * left(1.0) {
            excess = excess.unseen();
        }
        let rest: Vec<_> = (0..count).map(|k| off(k, 1.0 + excess.value)).collect();
        let neighbours = kept.windows(2).filter(|pair| pair[1] == pair[0] + 1);
        let (apart_rad, apart_floor_rad) = apart(series, &shifted, &floors);
        Some(Self {
            samples_per_turn: series.samples_per_turn(),
            mismatch: rms(kept.iter().map(|k| (Turns::of_one(series, *k) - shifted.recorded[*k]).norm())) / angle,
            floor: rms(floors.iter().copied()) / angle,
            lag,
            excess,
            correlation: correlation(neighbours.map(|pair| [&rest[pair[0]], &rest[pair[1]]])),
            apart_rad,
            apart_floor_rad,
            jumps: jumps.len(),
            first_jump_s: jumps.first().map(|k| series.times[k + 1]),
            update: Update::of(series, &shifted.recorded, &kept),
        })
    }
}

impl Turns {
    fn of_one(series: &Series, k: usize) -> Vector3<f64> {
        let span = [series.times[k], series.times[k + 1]];
        turned(&Stencil::between(&series.times, k, 6), &series.omega, span)
    }
}

/// Which turns stand out of their like: fewer than one in twenty, or they are the rule.
fn jumps(series: &Series, turns: &Turns, floors: &[f64]) -> Vec<usize> {
    let off: Vec<f64> = turns.recorded.iter().zip(&turns.made).map(|(a, b)| (a - b).norm()).collect();
    let middle = super::clock::median(&mut off.clone());
    let is_jump = |k: &usize| {
        // A frame's turn, and not what a torque that starts near by makes of ω's polynomial.
        let near = k.saturating_sub(3)..(k + 4).min(off.len());
        let sudden: f64 = near.map(|j| (series.omega[j + 1] - series.omega[j]).norm()).sum();
        let sudden = sudden * (series.times[k + 1] - series.times[*k]);
        let turn = turns.made[*k].norm().max(turns.recorded[*k].norm());
        off[*k] > JUMP * middle.max(floors[*k]) && off[*k] > 0.4 * turn && off[*k] > sudden
    };
    let found: Vec<usize> = (0..off.len()).filter(is_jump).collect();
    if found.len() * 20 < off.len() { found } else { Vec::new() }
}

/// The multiple of `direction` that the recorded turns have more than those that ω makes, by least squares.
fn along(
    recorded: &[Vector3<f64>],
    made: &[Vector3<f64>],
    direction: &[Vector3<f64>],
    floors: &[f64],
    kept: &[usize],
) -> Estimate {
    let (mut over, mut under, mut doubt) = (0.0, 0.0, 0.0);
    for &k in kept {
        over += (recorded[k] - made[k]).dot(&direction[k]);
        under += direction[k].norm_squared();
        doubt += floors[k] * direction[k].norm();
    }
    if under == 0.0 {
        return Estimate { value: 0.0, doubt: f64::INFINITY };
    }
    Estimate { value: over / under, doubt: doubt / under }
}

/// The shift of ω's times that fits best, by Newton's steps; none where ω changes too little to tell.
fn lag(series: &Series, plain: &Turns, floors: &[f64], kept: &[usize]) -> Estimate {
    let change: Vec<_> = (0..plain.made.len()).map(|k| series.omega[k + 1] - series.omega[k]).collect();
    let mut estimate = along(&plain.recorded, &plain.made, &change, floors, kept);
    let interval = series.span() / count_of(series.len());
    // Beyond a few samples it is no lag, and the polynomials do not reach.
    if !estimate.is_seen() || estimate.value.abs() > 2.0 * interval {
        return Estimate { value: 0.0, doubt: estimate.doubt };
    }
    for _ in 0..2 {
        let turns = Turns::of(series, estimate.value);
        let more = along(&turns.recorded, &turns.made, &change, floors, kept);
        estimate.value += more.value;
    }
    if Turns::of(series, estimate.value).mismatch() > LITTLE * plain.mismatch() {
        return estimate.unseen();
    }
    estimate
}

/// The largest angle between recorded attitudes and those to which ω leads from the first, and the doubt of it there.
fn apart(series: &Series, turns: &Turns, floors: &[f64]) -> (f64, f64) {
    let mut led: UnitQuaternion<f64> = series.attitude[0];
    let (mut apart, mut floor, mut doubt) = (0.0_f64, series.attitude_doubt, series.attitude_doubt);
    for (k, made) in turns.made.iter().enumerate() {
        led = UnitQuaternion::new_normalize((led * so3::exp(made)).into_inner());
        doubt += floors[k];
        let off = log(&(led.inverse() * series.attitude[k + 1])).norm();
        if off > apart {
            (apart, floor) = (off, doubt);
        }
    }
    (apart, floor)
}
