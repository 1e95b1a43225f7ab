use crate::numerics::two_sum;

/// Sums kept as high + low parts, so that adding many small terms loses nothing of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sums<const N: usize> {
    /// The sums, rounded.
    pub high: [f64; N],
    /// What rounding took.
    pub low: [f64; N],
}

impl<const N: usize> Sums<N> {
    pub fn new(values: [f64; N]) -> Self {
        Self { high: values, low: [0.0; N] }
    }

    /// Adds a term to each sum.
    pub fn add(&mut self, terms: [f64; N]) {
        for (i, term) in terms.into_iter().enumerate() {
            let (sum, error) = two_sum(self.high[i], term);
            (self.high[i], self.low[i]) = two_sum(sum, self.low[i] + error);
        }
    }

    pub fn is_finite(&self) -> bool {
        // A sum of finite numbers is NaN or infinite only where one overflows, which no state should come near.
        self.high.iter().chain(&self.low).all(|value| value.is_finite())
    }
}

impl Sums<1> {
    /// `value` − the sum, rounded once for all practical purposes.
    pub fn until(&self, value: f64) -> f64 {
        (value - self.high[0]) - self.low[0]
    }
}
