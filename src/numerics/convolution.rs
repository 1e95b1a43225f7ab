use super::{DoubleDouble, two_prod, two_sum};

/// Σ a(j) b(n − j) over j = 0 … n, of two slices of n + 1 coefficients: coefficient n of the product of two series.
///
/// The error is a few parts in 2¹⁰⁴ of Σ |a(j) b(n − j)|, as if the sum were taken in twice f64's precision and then
/// rounded `[OgitaRumpOishi05]`.
#[must_use]
pub fn convolution(a: &[DoubleDouble], b: &[DoubleDouble]) -> DoubleDouble {
    let (mut high, mut low) = (0.0, 0.0);
    for (a, b) in a.iter().zip(b.iter().rev()) {
        let (product, error) = two_prod(a.hi(), b.hi());
        let (sum, lost) = two_sum(high, product);
        high = sum;
        low += lost + (error + (a.hi() * b.lo() + a.lo() * b.hi()));
    }
    DoubleDouble::sum(high, low)
}
