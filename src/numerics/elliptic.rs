use super::DoubleDouble;

/// The complete elliptic integral K of the first kind, from the **complementary** modulus k′ = √(1 − m) > 0.
///
/// By the arithmetic-geometric mean; k′ rather than m so that nothing is lost near m = 1. [DLMF] 19.8.5.
#[must_use]
pub fn complete_k(complementary_modulus: DoubleDouble) -> DoubleDouble {
    let (mut a, mut g) = (DoubleDouble::ONE, complementary_modulus);
    // Quadratic once a and g are near; from k' = 1e-150 fourteen halvings of the exponent bring them there.
    for _ in 0..24 {
        let difference = a - g;
        let mean = (a + g).scale(0.5);
        if difference.hi().abs() <= 1e-16 * a.hi() {
            a = mean;
            break;
        }
        g = (a * g).sqrt();
        a = mean;
    }
    DoubleDouble::PI.scale(0.5) / a
}

/// Carlson's symmetric integral `R_F(x, y, z)` of the first kind; not negative, at most one of them zero.
///
/// By duplication, relative error some parts in 2¹⁰⁰. [Carlson95] §2, the series to seventh order from [DLMF] 19.36.1.
#[must_use]
pub fn carlson_rf(x: DoubleDouble, y: DoubleDouble, z: DoubleDouble) -> DoubleDouble {
    // The terms left out are of eighth order: 1e-4 each time gives 1e-32.
    const SPREAD: f64 = 1.5e-4;
    let (mut x, mut y, mut z) = (x, y, z);
    let third = DoubleDouble::from(3.0).recip();
    // Each round divides the spread by four; the first few hundred are for arguments of very different size.
    for _ in 0..600 {
        let mean = (x + y + z) * third;
        let spread = (mean - x).hi().abs().max((mean - y).hi().abs()).max((mean - z).hi().abs());
        if spread <= SPREAD * mean.hi() {
            break;
        }
        let (root_x, root_y, root_z) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = root_x * (root_y + root_z) + root_y * root_z;
        x = (x + lambda).scale(0.25);
        y = (y + lambda).scale(0.25);
        z = (z + lambda).scale(0.25);
    }
    let mean = (x + y + z) * third;
    let inverse = mean.recip();
    let (u, v) = (DoubleDouble::ONE - x * inverse, DoubleDouble::ONE - y * inverse);
    let w = -(u + v);
    let e2 = u * v - w.square();
    let e3 = u * v * w;
    (DoubleDouble::ONE + rf_series(e2, e3)) / mean.sqrt()
}

/// −E₂/10 + E₃/14 + E₂²/24 − 3E₂E₃/44 − 5E₂³/208 + 3E₃²/104 + E₂²E₃/16: the last four are below 1e-16 of the first
/// and need f64 only.
fn rf_series(e2: DoubleDouble, e3: DoubleDouble) -> DoubleDouble {
    let (p, q) = (e2.hi(), e3.hi());
    let small = -3.0 * p * q / 44.0 - 5.0 * p * p * p / 208.0 + 3.0 * q * q / 104.0 + p * p * q / 16.0;
    let first = e3 / DoubleDouble::from(14.0) - e2 / DoubleDouble::from(10.0);
    first + e2.square() / DoubleDouble::from(24.0) + DoubleDouble::from(small)
}
