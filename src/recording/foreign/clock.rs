/// Up to here, s, a whole number of ns is exact as an f64, and so is a time to its last place: a hundred days.
const EXACT_S: f64 = 9_007_199.254_740_992;

/// Reads times as decimals.
#[derive(Debug, Clone, Copy)]
pub(super) struct DecimalClock {
    decimals: u32,
    start_s: Option<i64>,
}

impl DecimalClock {
    /// Of times in 10^−`decimals` s, the first of which is `first`.
    pub fn new(decimals: u32, first: &str) -> Option<Self> {
        let plain = Self { decimals, start_s: None };
        if plain.seconds(first)?.abs() < EXACT_S {
            return Some(plain);
        }
        let (digits, places) = decimal(first, decimals)?;
        let start = if places <= 0 {
            digits.checked_mul(10_i128.checked_pow(places.unsigned_abs())?)?
        } else {
            digits.div_euclid(10_i128.checked_pow(places.unsigned_abs())?)
        };
        let start = i64::try_from(start).ok()?;
        // In ns, too, it has to fit.
        start.checked_mul(1_000_000_000)?;
        Some(Self { start_s: Some(start), ..plain })
    }

    /// What the clock showed at 0 s, ns.
    pub fn start_ns(self) -> i64 {
        self.start_s.unwrap_or(0) * 1_000_000_000
    }

    /// Seconds from the start; `None` if it is no finite number.
    #[expect(clippy::cast_precision_loss, reason = "rounded to the nearest f64")]
    pub fn seconds(self, text: &str) -> Option<f64> {
        let Some(start) = self.start_s else {
            let value = text.parse::<f64>().ok().filter(|value| value.is_finite())?;
            return Some(value / 10_u32.checked_pow(self.decimals).map(f64::from)?);
        };
        let (digits, places) = decimal(text, self.decimals)?;
        let power = 10_i128.checked_pow(places.unsigned_abs())?;
        if places <= 0 {
            return Some(digits.checked_mul(power)?.checked_sub(i128::from(start))? as f64);
        }
        let whole = digits.div_euclid(power) - i128::from(start);
        Some(whole as f64 + digits.rem_euclid(power) as f64 / power as f64)
    }
}

/// A decimal as digits and how many of them are behind the point, once divided by 10^`decimals`.
fn decimal(text: &str, decimals: u32) -> Option<(i128, i32)> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let digits = whole.strip_prefix(['+', '-']).unwrap_or(whole);
    if !is_digits(digits) || !is_digits(fraction) || digits.len() + fraction.len() > 36 {
        return None;
    }
    let value: i128 = format!("{whole}{fraction}").parse().ok()?;
    let places = i32::try_from(fraction.len()).ok()?.checked_add(decimals.cast_signed())?.checked_sub(exponent)?;
    Some((value, places))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An f64 has steps of 0.24 µs there: read as it stands, the second time would be 119 ns off.
    #[test]
    fn absolute_times_keep_their_nanoseconds() {
        let clock = DecimalClock::new(0, "1700000000.123456789").expect("a time");
        assert_eq!(clock.start_ns(), 1_700_000_000_000_000_000);
        assert_eq!(clock.seconds("1700000001.000000001"), Some(1.000_000_001));
        assert_eq!(clock.seconds("1.70000000150e9"), Some(1.5));
        let clock = DecimalClock::new(9, "1700000000123456789").expect("a time");
        assert_eq!(clock.seconds("1700000000123456790"), Some(0.123_456_79));
    }

    #[test]
    fn times_of_a_run_are_the_nearest_numbers() {
        let clock = DecimalClock::new(3, "0").expect("a time");
        assert_eq!((clock.start_ns(), clock.seconds("0.1"), clock.seconds("12")), (0, Some(0.0001), Some(0.012)));
        assert_eq!((clock.seconds("x"), clock.seconds("nan")), (None, None));
        assert!(DecimalClock::new(0, "1e300").is_none(), "no clock shows it");
    }
}
