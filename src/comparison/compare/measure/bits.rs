/// How the bits of two columns differ.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Bits {
    /// At how many samples at least one component has other bits.
    pub differing: u64,
    /// The first of them.
    pub first: Option<Mark>,
    /// The most units in the last place between two components; 2⁶⁴ − 1 where one is NaN and the other has other bits.
    pub most_ulps: u64,
}

/// Two numbers that are not the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// When, s.
    pub time_s: f64,
    /// Which component.
    pub component: usize,
    /// What the one side has, and the other.
    pub values: [f64; 2],
}

impl Bits {
    /// Looks at one sample of which something is known to differ.
    pub(in crate::comparison) fn include<const N: usize>(&mut self, time_s: f64, a: [f64; N], b: [f64; N]) {
        let mut is_same = true;
        for component in 0..N {
            let values = [a[component], b[component]];
            if values[0].to_bits() == values[1].to_bits() {
                continue;
            }
            is_same = false;
            self.most_ulps = self.most_ulps.max(ulps(values[0], values[1]));
            self.first = self.first.or(Some(Mark { time_s, component, values }));
        }
        self.differing += u64::from(!is_same);
    }
}

/// How many numbers further on `b` is; −0 is next to 0.
fn ulps(a: f64, b: f64) -> u64 {
    if a.is_nan() || b.is_nan() { u64::MAX } else { place(a).abs_diff(place(b)) }
}

/// The place of a number among all, in order.
fn place(value: f64) -> i64 {
    let bits = value.to_bits().cast_signed();
    if bits < 0 { -1 - (bits & i64::MAX) } else { bits }
}

#[cfg(test)]
mod tests {
    use super::ulps;

    #[test]
    fn numbers_are_counted_across_zero() {
        assert_eq!(ulps(1.0, 1.0_f64.next_up()), 1);
        assert_eq!(ulps(-1.0, (-1.0_f64).next_up()), 1);
        assert_eq!(ulps(-0.0, 0.0), 1);
        assert_eq!(ulps(-0.0_f64.next_up(), 0.0_f64.next_up()), 3);
        assert_eq!(ulps(f64::NEG_INFINITY, f64::INFINITY), 2 * f64::INFINITY.to_bits() + 1);
        assert_eq!(ulps(f64::NAN, 1.0), u64::MAX);
    }
}
