use super::motion::{Series, exact};
use crate::numerics::{Scalar, Tape};

/// The longest step, s.
pub(in crate::propagation) const LONGEST_STEP: f64 = 1e100;
/// By how much the argument of a sine or an exponential may change within a step: more than a series follows, so that only
/// those that vanish now, and may not for long, are held back.
const ARGUMENTS: f64 = 16.0;
/// How far off the series of a guard may be at a step's end, of its size: what this does to the time of a switch is squared
/// in the motion.
const GUARDS: f64 = 1e-13;

/// The σ at which the last two coefficients still add no more than the tolerance; infinity where they vanish.
pub(super) fn step_ratio<F: Scalar>(series: &Series<F>, tape: &Tape, tolerance: f64) -> f64 {
    let ratio = |k: usize| {
        let last = series.relative(k);
        if last > 0.0 { libm::pow(tolerance / last, 1.0 / exact(k)) } else { f64::INFINITY }
    };
    let arguments = series.expansion.reach_of_arguments(tape, series.order, ARGUMENTS);
    let guards = series.expansion.reach_of_guards(tape, series.order, tolerance.max(GUARDS));
    ratio(series.order - 1).min(ratio(series.order)).min(arguments).min(guards)
}

/// The power of two at or below a positive number; 1 for what has none.
pub(in crate::propagation) fn power_of_two(value: f64) -> f64 {
    if value.is_normal() && value > 0.0 { libm::ldexp(1.0, libm::ilogb(value)) } else { 1.0 }
}
