//! Where a polynomial changes its sign.

use super::recurrence::exact;

/// What counts as zero, of a polynomial's largest coefficient: noise of f64, with some room.
const NOISE: f64 = 1.0 / 8_796_093_022_208.0; // 2⁻⁴³
/// No crossing is looked for before this part of the way, so that what has just crossed goes on.
const SHORTEST: f64 = 1.0 / 4_294_967_296.0; // 2⁻³²
/// How finely crossings are told apart, as a part of the way.
const FINEST: f64 = 1.0 / 1_125_899_906_842_624.0; // 2⁻⁵⁰
/// Places looked at, at most: a polynomial that hugs zero is let go.
const MOST_LOOKS: usize = 4096;

/// Whether the polynomial is above zero right after σ = 0; `None` where it is zero all along.
pub(super) fn sign_ahead(polynomial: &[f64]) -> Option<bool> {
    let noise = NOISE * size(polynomial);
    polynomial.iter().find(|coefficient| coefficient.abs() > noise).map(|coefficient| *coefficient > 0.0)
}

/// The first σ in (0, end] at which the polynomial has gone below zero by more than noise.
pub(super) fn first_below(polynomial: &[f64], end: f64) -> Option<f64> {
    let noise = NOISE * size(polynomial);
    if noise == 0.0 || !end.is_finite() {
        return None;
    }
    // From the last interval to the first, so that the first is looked at first.
    let mut waiting = vec![(SHORTEST * end, end)];
    for _ in 0..MOST_LOOKS {
        let (from, to) = waiting.pop()?;
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let ([height, slope], bend) = (value_and_slope(polynomial, middle), most_bent(polynomial, to));
        if height - half * (slope.abs() + 0.5 * half * bend) >= -noise {
            continue;
        }
        if half < FINEST * end {
            if value_and_slope(polynomial, to)[0] < -noise {
                return Some(to);
            }
            continue;
        }
        waiting.push((middle, to));
        waiting.push((from, middle));
    }
    None
}

fn size(polynomial: &[f64]) -> f64 {
    polynomial.iter().fold(0.0, |size, coefficient| coefficient.abs().max(size))
}

/// The value and the slope at σ.
fn value_and_slope(polynomial: &[f64], sigma: f64) -> [f64; 2] {
    polynomial
        .iter()
        .rev()
        .fold([0.0; 2], |[value, slope], coefficient| [value * sigma + coefficient, slope * sigma + value])
}

/// A bound on the size of the second derivative from 0 to σ.
fn most_bent(polynomial: &[f64], sigma: f64) -> f64 {
    let bends = polynomial.iter().enumerate().skip(2).rev();
    bends.fold(0.0, |sum, (k, coefficient)| sum * sigma + exact(k * (k - 1)) * coefficient.abs())
}
