use super::row::Row;
use super::series::{ORDER_MAX, RECIPROCAL, Rows, Series};

/// The lowest order worth its steps.
const ORDER_MIN: usize = 4;

/// The longest step, s, of a body at rest for ever: as good as infinite, and its square is still a number.
pub(super) const LONGEST_STEP: f64 = 1e100;

/// The order at which the way is cheapest: the next even one above 3 − 0.7 ln tolerance.
///
/// `[JZ05]` §3 has 1 − ½ ln tolerance for steps whose cost grows with the square of the order. Two orders at a time in
/// vector registers cost less than that, and longer steps of higher order are cheaper.
pub(super) fn order_for(tolerance: f64) -> usize {
    let order = 2.0 * (0.5 * (3.0 - 0.7 * libm::log(tolerance))).ceil();
    // Small positive integers, so that all three casts are exact.
    #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]
    let order = order.clamp(ORDER_MIN as f64, ORDER_MAX as f64) as usize;
    order
}

/// The σ at which the last two coefficients still add no more than the tolerance; infinity where they vanish.
///
/// An attitude may be off by the tolerance in rad. Rates may be off by the tolerance of their own size, or of one turn
/// of the series' unit where that is less: `|ω_p| σ^(p+1)` then moves the attitude by less too.
#[inline(always)]
pub(super) fn step_ratio(series: &Series, order: usize, tolerance: f64) -> f64 {
    let rates = shrink(scale(&series.rates.rows).min(1.0));
    let position = shrink(scale(&series.position));
    let goal = rough_log2(tolerance);
    let [last_but_one, last] = [order - 1, order].map(
        #[inline(always)]
        |k| series.attitude[k].largest(series.rates.rows[k] * rates).largest(series.position[k] * position).magnitude(),
    );
    rough_exp2(power(goal, last_but_one, order - 1).min(power(goal, last, order)))
}

/// log₂ of (tolerance / size)^(1/k), from log₂ of the tolerance.
#[inline(always)]
fn power(goal: f64, size: f64, k: usize) -> f64 {
    if size > 0.0 { (goal - rough_log2(size)) * RECIPROCAL[k] } else { f64::INFINITY }
}

/// log₂ of a positive number within 0.01, which the root makes less than 0.2 %: a step needs no more, and this costs
/// a tenth of the real one.
#[inline(always)]
fn rough_log2(value: f64) -> f64 {
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    let bits = value.to_bits();
    let exponent = f64::from(u32::try_from(bits >> 52).unwrap_or(0)) - 1023.0;
    let mantissa = f64::from_bits(bits & MANTISSA | 1.0_f64.to_bits());
    exponent + (2.0 - mantissa / 3.0) * mantissa - 5.0 / 3.0
}

/// 2 to a power within 0.3 %; infinity where the power is beyond all sense.
#[inline(always)]
fn rough_exp2(power: f64) -> f64 {
    if power > 1000.0 {
        return f64::INFINITY;
    }
    // Positive, so that the cast rounds down.
    let power = power.max(-1000.0) + 1023.0;
    // Between 23 and 2023.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let exponent = power as u32;
    let rest = power - f64::from(exponent);
    f64::from_bits(u64::from(exponent) << 52) * (1.0 + rest * (0.656_5 + 0.343_5 * rest))
}

/// The size of a quantity over the step, from its first coefficients.
#[inline(always)]
fn scale(rows: &Rows) -> f64 {
    rows[0].largest(rows[1]).largest(rows[2]).magnitude()
}

/// Sizes below this count as this: rates that damping has all but ended must not be followed to the last denormal digit.
const SMALLEST_SIZE: f64 = 1e-280;

/// What makes coefficients relative to a size; 0 where there is none.
#[inline(always)]
fn shrink(size: f64) -> Row {
    Row::splat(if size > 0.0 { 1.0 / size.max(SMALLEST_SIZE) } else { 0.0 })
}

/// The power of two at or below a positive number; 1 for what has none.
pub(super) fn power_of_two(value: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let power = f64::from_bits(value.to_bits() & EXPONENT);
    if power.is_normal() { power } else { 1.0 }
}
