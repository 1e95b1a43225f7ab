use nalgebra::Vector3;

use super::cause::{Cause, Finding};
use super::kinematics::{CLEAR, Estimate, Kinematics};
use super::laws::Steps;
use super::series::{Series, is_single};
use super::{Laws, Verification};
use crate::recording::Observed;

/// Noise of a sample enters one interval with one sign and the next with the other: their correlation is −½.
const AGAINST: f64 = -0.3;
/// Errors of a method are much the same in the next interval; those of rounding are not.
const ALIKE: f64 = 0.5;
/// What roundings to 24 bits leave of ω in an interval, at most.
const ROUNDING: f64 = 30.0 / (1 << 24) as f64;

/// Why ω is off where no law and no order explains its errors.
pub(super) fn of_rates(steps: &Steps, series: &Series) -> Finding {
    let size = steps.defect() / series.rate().max(f64::MIN_POSITIVE);
    let neighbours = steps.intervals.windows(2).enumerate().filter(|(_, pair)| pair[1] == pair[0] + 1);
    let correlation = correlation(neighbours.map(|(index, _)| [&steps.defects[index], &steps.defects[index + 1]]));
    let found = |cause, evidence| Finding { cause, share: 0.0, evidence };
    if correlation < AGAINST {
        return found(Cause::Noise, against(correlation));
    }
    let told = format!("errors of {size:.1e} of ω in an interval");
    if size < ROUNDING && correlation < ALIKE {
        let unlike = "each unlike the one before, as rounding to 24 bits makes";
        return found(Cause::SinglePrecision, format!("{told}, {unlike} (correlation {correlation:.2})"));
    }
    found(Cause::Truncation, format!("{told}, of no known form"))
}

/// Why attitudes leave the exact motion although ω is right from sample to sample.
pub(super) fn of_motion(found: &Verification, observed: &Observed) -> Finding {
    if let Some(noise) = found.kinematics.as_ref().and_then(noise) {
        return noise;
    }
    let is_single =
        observed.attitude.as_ref().is_none_or(is_single) && observed.angular_velocity.as_ref().is_none_or(is_single);
    // Rounding walks at random: what adds up to more is a method's, however small in each interval.
    if let Some(laws) = found.laws.as_ref().filter(|laws| is_single && !gains(laws)) {
        let within = format!("errors of {:.1e} of ω in an interval are within its rounding", laws.defect);
        let evidence = format!("every number is a 32-bit float, {within}, and add up in E and L no faster");
        return Finding { cause: Cause::SinglePrecision, share: 0.0, evidence };
    }
    Finding {
        cause: Cause::Truncation,
        share: 0.0,
        evidence: "attitudes leave the exact motion although ω is right from sample to sample".into(),
    }
}

/// Why attitudes go another way than ω where neither a lag nor a factor explains it.
pub(super) fn of_turning(kinematics: &Kinematics) -> Finding {
    noise(kinematics).unwrap_or_else(|| Finding {
        cause: Cause::RatesDisagree,
        share: 0.0,
        evidence: format!(
            "they differ by {:.1e} of each turn, and neither a lag nor a factor explains it",
            kinematics.mismatch
        ),
    })
}

fn noise(kinematics: &Kinematics) -> Option<Finding> {
    let is_seen = kinematics.mismatch > CLEAR * kinematics.floor && kinematics.correlation < AGAINST;
    is_seen.then(|| Finding { cause: Cause::Noise, share: 0.0, evidence: against(kinematics.correlation) })
}

/// Whether errors add up faster than rounding, of which there may be many in an interval.
fn gains(laws: &Laws) -> bool {
    let is_clear = |gain: &Estimate| gain.value.abs() > CLEAR * gain.doubt;
    is_clear(&laws.energy_per_turn)
        || is_clear(&laws.momentum_per_turn)
        || laws.direction_rad.as_ref().is_some_and(is_clear)
}

fn against(correlation: f64) -> String {
    format!("errors of neighbouring intervals go against each other (correlation {correlation:.2})")
}

/// Of errors with those of the next interval, −1 to 1; 0 of none.
pub(super) fn correlation<'a>(neighbours: impl Iterator<Item = [&'a Vector3<f64>; 2]>) -> f64 {
    let (product, square) = neighbours
        .fold((0.0, 0.0), |(product, square), [one, next]| (product + one.dot(next), square + one.norm_squared()));
    if square > 0.0 { product / square } else { 0.0 }
}
