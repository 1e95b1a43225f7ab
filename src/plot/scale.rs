use std::ops::RangeInclusive;

/// How values become places along an axis, and where its ticks are.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// The value at its start.
    pub from: f64,
    /// The value at its end.
    pub to: f64,
    /// Whether equal ratios are equally far.
    pub is_logarithmic: bool,
    /// Values with a line and a label.
    pub ticks: Vec<Tick>,
    /// Values with a short line only.
    pub minor_ticks: Vec<f64>,
    /// Labels count in this power of ten.
    pub power: i32,
}

/// A value on an axis, as it is written there.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// The value.
    pub value: f64,
    /// Its label.
    pub label: String,
}

/// Labels count in units as long as the largest number is in here, and in powers of ten outside.
const HANDY: RangeInclusive<f64> = 1e-3..=99_999.0;
/// Ticks between whole powers of ten help as long as there are no more powers than this.
const DECADES_WITH_MINOR_TICKS: i32 = 5;

impl Scale {
    /// Equal steps equally far, from one value to the other exactly, with at most so many ticks.
    #[must_use]
    pub fn linear(from: f64, to: f64, most_ticks: usize) -> Self {
        let (from, to) = if from < to { (from, to) } else { (from - 0.5, from + 0.5) };
        let step = step((to - from) / count(most_ticks.max(2)));
        let largest = from.abs().max(to.abs());
        let power = if largest == 0.0 || HANDY.contains(&largest) { 0 } else { exponent(largest) };
        let unit = ten_to(power);
        let places = places(step / unit);
        let first = (from / step - 1e-9).ceil();
        let ticks = (0..=2 * most_ticks).map(|index| (first + count(index)) * step);
        let ticks = ticks.take_while(|value| *value <= to + 1e-9 * step);
        let label = |value: f64| signed(format!("{:.places$}", value / unit + 0.0));
        let ticks = ticks.map(|value| Tick { value, label: label(value) }).collect();
        Self { from, to, is_logarithmic: false, ticks, minor_ticks: Vec::new(), power }
    }

    /// The same around all of `values`, a little wider; around a value that hardly changes, a thousandth of it.
    #[must_use]
    pub fn around(values: impl Iterator<Item = f64>, most_ticks: usize) -> Self {
        let (least, greatest) = extremes(values);
        let size = least.abs().max(greatest.abs());
        let room = (0.06 * (greatest - least)).max(5e-4 * size);
        let room = if room > 0.0 && room.is_finite() { room } else { 0.5 };
        Self::linear(least - room, greatest + room, most_ticks)
    }

    /// Equal ratios equally far, over whole powers of ten around two positive values, with about so many labels.
    #[must_use]
    pub fn logarithmic(least: f64, greatest: f64, most_ticks: usize) -> Self {
        let least = if least > 0.0 && least.is_finite() { least } else { 1.0 };
        let low = floor(libm::log10(least) + 1e-9);
        let high = -floor(-libm::log10(greatest.max(least)) + 1e-9);
        let high = high.max(low + 1);
        let every = (high - low).unsigned_abs().div_ceil(u32::try_from(most_ticks.max(2)).unwrap_or(u32::MAX));
        let is_labelled = |power: &i32| power.rem_euclid(i32::try_from(every).unwrap_or(1)) == 0;
        let ticks = (low..=high).filter(is_labelled);
        let ticks = ticks.map(|power| Tick { value: ten_to(power), label: power_of_ten(power) }).collect();
        let minor_ticks = if high - low <= DECADES_WITH_MINOR_TICKS {
            (low..high).flat_map(|power| (2..10).map(move |digit| f64::from(digit) * ten_to(power))).collect()
        } else {
            Vec::new()
        };
        Self { from: ten_to(low), to: ten_to(high), is_logarithmic: true, ticks, minor_ticks, power: 0 }
    }

    /// Where `value` is, 0 at the start and 1 at the end; what has no place on a logarithmic axis is far below it.
    #[must_use]
    pub fn fraction(&self, value: f64) -> f64 {
        if !self.is_logarithmic {
            return (value - self.from) / (self.to - self.from);
        }
        if value <= 0.0 {
            return -1.0;
        }
        libm::log10(value / self.from) / libm::log10(self.to / self.from)
    }

    /// `unit` as the labels count it: `10⁻⁶ rad/s`.
    #[must_use]
    pub fn counted(&self, unit: &str) -> String {
        match (self.power, unit.strip_prefix("1e").and_then(|power| power.parse::<i32>().ok())) {
            // A number's own power, such as that of drifts.
            (power, Some(own)) => power_of_ten(power + own),
            (0, None) => unit.to_owned(),
            (power, None) if unit == "1" || unit.is_empty() => power_of_ten(power),
            (power, None) => format!("{} {unit}", power_of_ten(power)),
        }
    }
}

/// The least and the greatest finite value; 0 and 0 of none.
pub fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let range = values.filter(|value| value.is_finite()).fold(None, |range: Option<(f64, f64)>, value| {
        let (least, greatest) = range.unwrap_or((value, value));
        Some((least.min(value), greatest.max(value)))
    });
    range.unwrap_or_default()
}

/// 10 to a whole power, as people write it.
#[must_use]
pub fn power_of_ten(power: i32) -> String {
    let raised = |letter: char| match letter {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        _ => '⁹',
    };
    format!("10{}", power.to_string().chars().map(raised).collect::<String>())
}

/// A number with four digits as people write it: `0.0025`, `2.5·10⁻⁹`.
#[must_use]
pub fn figure(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return signed(format!("{value}"));
    }
    let rounded = format!("{value:.3e}");
    let (digits, power) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let power: i32 = power.parse().unwrap_or_default();
    let short = |digits: &str| match digits.split_once('.') {
        Some(_) => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        None => digits.to_owned(),
    };
    if (-4..5).contains(&power) {
        let places = usize::try_from(3 - power).unwrap_or(0);
        return signed(short(&format!("{value:.places$}")));
    }
    signed(format!("{}·{}", short(digits), power_of_ten(power)))
}

/// With a minus sign as long as a plus.
fn signed(text: String) -> String {
    text.strip_prefix('-').map(|rest| format!("−{rest}")).unwrap_or(text)
}

/// The smallest of 1, 2 and 5 times a power of ten that is at least `step`.
fn step(step: f64) -> f64 {
    let unit = ten_to(exponent(step));
    let nice = [1.0, 2.0, 5.0, 10.0].into_iter().find(|nice| nice * unit >= step * (1.0 - 1e-9));
    nice.unwrap_or(10.0) * unit
}

/// How many decimals tell multiples of `step` apart.
fn places(step: f64) -> usize {
    usize::try_from(-exponent(step * (1.0 + 1e-9))).unwrap_or(0)
}

fn exponent(value: f64) -> i32 {
    floor(libm::log10(value))
}

#[expect(clippy::cast_possible_truncation, reason = "the power of an f64 is between -324 and 308")]
fn floor(value: f64) -> i32 {
    value.floor() as i32
}

/// Correctly rounded, which a product of tens is not.
fn ten_to(power: i32) -> f64 {
    format!("1e{power}").parse().unwrap_or(f64::MAX)
}

#[expect(clippy::cast_precision_loss, reason = "ticks, a dozen at most")]
const fn count(number: usize) -> f64 {
    number as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale) -> Vec<&str> {
        scale.ticks.iter().map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_numbers_with_as_many_digits_as_they_need() {
        assert_eq!(labels(&Scale::linear(0.0, 20.0, 5)), ["0", "5", "10", "15", "20"]);
        assert_eq!(labels(&Scale::linear(-0.31, 0.3, 6)), ["−0.2", "0.0", "0.2"]);
        assert_eq!(labels(&Scale::linear(0.9995, 1.0005, 4)), ["0.9995", "1.0000", "1.0005"]);
        let small = Scale::linear(-4e-6, 4e-6, 5);
        assert_eq!((labels(&small), small.counted("N m")), (vec!["−4", "−2", "0", "2", "4"], "10⁻⁶ N m".into()));
        let drift = Scale::linear(0.0, 2e6, 5);
        assert_eq!((drift.power, drift.counted("1e-15")), (6, "10⁻⁹".into()));
    }

    #[test]
    fn a_logarithmic_axis_has_whole_powers_and_not_too_many_labels() {
        let scale = Scale::logarithmic(3e-16, 0.2, 6);
        assert_eq!((scale.from, scale.to), (1e-16, 1.0));
        assert_eq!(labels(&scale), ["10⁻¹⁵", "10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"]);
        assert!((scale.fraction(1e-8) - 0.5).abs() < 1e-12);
        assert!(scale.fraction(0.0) < 0.0, "zero is below every axis");
        assert_eq!(Scale::logarithmic(1e-3, 1e-3, 5).to, 1e-2);
    }

    #[test]
    fn figures_have_four_digits() {
        let shown = [0.0025, -1.0, 12345.6, 2.5e-9, 8.0345e37, 0.0, 299.0].map(figure);
        assert_eq!(shown, ["0.0025", "−1", "12346", "2.5·10⁻⁹", "8.034·10³⁷", "0", "299"]);
    }

    #[test]
    fn what_hardly_changes_is_not_blown_up() {
        let scale = Scale::around([0.5, 0.5 + 1e-15].into_iter(), 5);
        assert!(scale.to - scale.from > 4e-4);
        let nothing = Scale::around(std::iter::empty(), 5);
        assert_eq!((nothing.from, nothing.to), (-0.5, 0.5));
        let hostile = Scale::around([f64::NAN, f64::INFINITY, -1e308, 1e308].into_iter(), 5);
        assert!(hostile.ticks.len() < 20);
    }
}
