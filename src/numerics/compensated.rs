use super::two_sum;

/// A running sum whose rounding errors are kept: as if summed in 106 bits. `[Neumaier74]`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Compensated {
    sum: f64,
    lost: f64,
}

impl Compensated {
    /// A sum that starts at `start`.
    #[must_use]
    pub fn new(start: f64) -> Self {
        Self { sum: start, lost: 0.0 }
    }

    /// Adds a term, of any size.
    #[inline]
    pub fn add(&mut self, term: f64) {
        let (sum, error) = two_sum(self.sum, term);
        // Folded in at once, so that `sum` is always the best f64 and `lost` less than half an ulp of it.
        (self.sum, self.lost) = two_sum(sum, self.lost + error);
    }

    /// The sum, rounded.
    #[inline]
    #[must_use]
    pub fn value(self) -> f64 {
        self.sum
    }

    /// What rounding takes off [`Self::value`].
    #[inline]
    #[must_use]
    pub fn lost(self) -> f64 {
        self.lost
    }
}

impl From<Compensated> for f64 {
    fn from(sum: Compensated) -> Self {
        sum.sum
    }
}
