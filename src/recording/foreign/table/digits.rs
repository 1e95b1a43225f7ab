use crate::recording::foreign::own::DOUBLE;

/// What the digits of a table say of how exact its numbers are.
///
/// A program prints all its numbers alike: with so many decimals, or with so many digits. With 16 digits and more they
/// are what it had.
#[derive(Debug, Clone, Copy)]
pub(in crate::recording) struct Digits {
    least_decimals: usize,
    most_decimals: usize,
    most_significant: usize,
    has_exponent: bool,
}

/// Digits that an f64 needs; of numbers that need them all, some end in a zero or two, which may be left out.
const ALL: usize = 16;
/// Digits that an f32 needs.
const OF_SINGLE: usize = 9;
/// Half a unit in the last place of an f32.
const SINGLE: f64 = 1.0 / 16_777_216.0;

impl Default for Digits {
    fn default() -> Self {
        Self { least_decimals: usize::MAX, most_decimals: 0, most_significant: 0, has_exponent: false }
    }
}

impl Digits {
    /// Takes a number's text in, which parses.
    pub fn see(&mut self, text: &str) {
        let (mantissa, exponent) = text.split_once(['e', 'E']).map_or((text, None), |(text, end)| (text, Some(end)));
        let decimals = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let digits = mantissa.bytes().filter(u8::is_ascii_digit).skip_while(|digit| *digit == b'0').count();
        self.least_decimals = self.least_decimals.min(decimals);
        self.most_decimals = self.most_decimals.max(decimals);
        self.most_significant = self.most_significant.max(digits);
        self.has_exponent |= exponent.is_some();
    }

    /// Half a unit in the last place, relative to `largest`.
    pub fn resolution(self, largest: f64) -> f64 {
        if self.most_significant >= ALL {
            return DOUBLE;
        }
        if self.is_fixed() && largest > 0.0 {
            return (self.last_place() / 2.0 / largest).clamp(DOUBLE, 1.0);
        }
        let digits = 5.0 * tenth_to_the(self.most_significant);
        if self.most_significant <= OF_SINGLE { digits.clamp(SINGLE, 1.0) } else { digits.max(DOUBLE) }
    }

    fn last_place(self) -> f64 {
        tenth_to_the(self.most_decimals)
    }

    /// Whether all have as many decimals.
    fn is_fixed(self) -> bool {
        !self.has_exponent && self.least_decimals == self.most_decimals
    }
}

/// 10^−`power`, rounded once.
fn tenth_to_the(power: usize) -> f64 {
    format!("1e-{power}").parse().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(texts: &[&str]) -> Digits {
        let mut digits = Digits::default();
        for text in texts {
            digits.see(text);
        }
        digits
    }

    #[test]
    fn the_way_numbers_are_printed_tells_how_exact_they_are() {
        let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        near(of(&["0.123456", "-12.000000"]).resolution(12.0), 0.5e-6 / 12.0);
        near(of(&["1.23456e-03", "7.00000e+00"]).resolution(7.0), 0.5e-5);
        assert_eq!(of(&["0.5", "0.12345678901234567", "2"]).resolution(2.0), DOUBLE, "the shortest that reads back");
        near(of(&["0.70710677", "0.5"]).resolution(1.0), SINGLE);
    }
}
