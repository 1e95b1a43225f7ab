use super::series::{ORDER_MAX, RECIPROCAL, Row, Rows, Series};

/// The lowest order worth its steps.
const ORDER_MIN: usize = 4;

/// The order at which a step of best length is cheapest: −½ ln tolerance + 1 `[JZ05]` §3.
pub(super) fn order_for(tolerance: f64) -> usize {
    let order = (1.0 - 0.5 * libm::log(tolerance)).ceil();
    // Small positive integers, so that all three casts are exact.
    #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]
    let order = order.clamp(ORDER_MIN as f64, ORDER_MAX as f64) as usize;
    order
}

/// The σ at which the last two coefficients still add no more than the tolerance; infinity where they vanish.
///
/// An attitude may be off by the tolerance in rad. Rates may be off by the tolerance of their own size, or of one turn
/// of the series' unit where that is less: `|ω_p| σ^(p+1)` then moves the attitude by less too.
pub(super) fn step_ratio(series: &Series, order: usize, tolerance: f64) -> f64 {
    let rates = scale(&series.rates).min(1.0);
    let position = scale(&series.position);
    let ratio = |k: usize| {
        let size =
            [largest(&series.attitude[k]), relative(&series.rates[k], rates), relative(&series.position[k], position)];
        let size = size.into_iter().fold(0.0, f64::max);
        // The binary logarithm of (tolerance / size)^(1/k).
        if size > 0.0 { (rough_log2(tolerance) - rough_log2(size)) * RECIPROCAL[k] } else { f64::INFINITY }
    };
    rough_exp2(ratio(order - 1).min(ratio(order)))
}

/// log₂ of a positive number within 0.01, which the root makes less than 0.2 %: a step needs no more, and this costs
/// a tenth of the real one.
fn rough_log2(value: f64) -> f64 {
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    let bits = value.to_bits();
    let exponent = f64::from(u32::try_from(bits >> 52).unwrap_or(0)) - 1023.0;
    let mantissa = f64::from_bits(bits & MANTISSA | 1.0_f64.to_bits());
    exponent + (2.0 - mantissa / 3.0) * mantissa - 5.0 / 3.0
}

/// 2 to a power within 0.3 %; infinity where the power is beyond all sense.
fn rough_exp2(power: f64) -> f64 {
    if power > 1000.0 {
        return f64::INFINITY;
    }
    let whole = power.max(-1000.0).floor();
    let rest = power.max(-1000.0) - whole;
    // The range makes the cast exact, and the result a normal number.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let exponent = (whole + 1023.0) as u64;
    f64::from_bits(exponent << 52) * (1.0 + rest * (0.656_5 + 0.343_5 * rest))
}

/// The size of a quantity over the step, from its first coefficients.
fn scale(rows: &Rows) -> f64 {
    rows[..3].iter().map(largest).fold(0.0, f64::max)
}

fn relative(row: &Row, scale: f64) -> f64 {
    if scale > 0.0 { largest(row) / scale } else { 0.0 }
}

fn largest(row: &Row) -> f64 {
    row.iter().fold(0.0, |most, value| value.abs().max(most))
}

/// The power of two at or below a positive number; 1 for what has none.
pub(super) fn power_of_two(value: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let power = f64::from_bits(value.to_bits() & EXPONENT);
    if power.is_normal() { power } else { 1.0 }
}
