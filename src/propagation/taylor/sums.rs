use super::row::Row;
use crate::numerics::two_sum;

/// A vector's sums kept as high + low parts, so that adding many small terms loses nothing of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sums {
    /// The sums, rounded.
    pub high: Row,
    /// What rounding took.
    pub low: Row,
}

impl Sums {
    pub const fn new(values: Row) -> Self {
        Self { high: values, low: Row::ZERO }
    }

    /// Adds a term to each sum.
    #[inline(always)]
    pub fn add(&mut self, terms: Row) {
        let (sum, error) = two_sums(self.high, terms);
        (self.high, self.low) = two_sums(sum, self.low + error);
    }

    /// NaN or infinite where a component is. Sums of finite numbers overflow only where no state should come near.
    #[inline(always)]
    pub fn witness(&self) -> Row {
        self.high + self.low
    }
}

#[inline(always)]
fn two_sums(a: Row, b: Row) -> (Row, Row) {
    let sum = a + b;
    let b_rounded = sum - a;
    (sum, (a - (sum - b_rounded)) + (b - b_rounded))
}

/// A time, s, kept in the same way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Instant {
    pub high: f64,
    pub low: f64,
}

impl Instant {
    pub const fn new(time: f64) -> Self {
        Self { high: time, low: 0.0 }
    }

    /// The same, `step` seconds later.
    #[must_use]
    pub fn after(self, step: f64) -> Self {
        let (sum, error) = two_sum(self.high, step);
        let (high, low) = two_sum(sum, self.low + error);
        Self { high, low }
    }

    /// `time` − this one, s, rounded once for all practical purposes.
    pub fn until(&self, time: f64) -> f64 {
        (time - self.high) - self.low
    }
}
