use super::DoubleDouble;

/// The complete elliptic integral K of the first kind, from the **complementary** modulus k′ = √(1 − m) > 0.
///
/// By the arithmetic-geometric mean; k′ rather than m so that nothing is lost near m = 1. `[DLMF]` 19.8.5.
#[must_use]
pub fn complete_k(complementary_modulus: DoubleDouble) -> DoubleDouble {
    let (mut a, mut g) = (DoubleDouble::ONE, complementary_modulus);
    // Quadratic once a and g are near; from k' = 1e-150 fourteen halvings of the exponent bring them there.
    for _ in 0..24 {
        let difference = (a - g).hi();
        let mean = (a + g).scale(0.5);
        // What further rounds would take off, but for the fourth power of the difference.
        if difference.abs() <= 1e-8 * a.hi() {
            a = mean - DoubleDouble::from(difference * difference / (16.0 * mean.hi()));
            break;
        }
        g = (a * g).sqrt();
        a = mean;
    }
    DoubleDouble::PI.scale(0.5) / a
}

/// The nome q = e^(−πK′/K) where it is at most 0.044, so where m ≤ ½, from m and k′ = √(1 − m).
///
/// Relative error some parts in 2¹⁰⁰, however small m.
#[must_use]
pub fn nome(parameter: DoubleDouble, complementary_modulus: DoubleDouble) -> DoubleDouble {
    let one = DoubleDouble::ONE;
    // ½ (1 − √k′)/(1 + √k′), with what would cancel taken from m.
    let epsilon =
        parameter.scale(0.5) / ((one + complementary_modulus) * (one + complementary_modulus.sqrt()).square());
    // This is θ₂/θ₃ in q⁴, whose inverse is a series in ε⁴, below 4e-6.
    let x = epsilon.square().square();
    let t = x.hi();
    let small = t * (150.0 + t * (1707.0 + t * (20_910.0 + t * 268_616.0)));
    let rest = x * (DoubleDouble::sum(15.0, small) * x + 2.0.into());
    epsilon + epsilon * rest
}

/// K from a nome of at most 0.044: π/2 θ₃(0, q)². `[DLMF]` 20.2.3, 20.9.2.
#[must_use]
pub fn complete_k_of_nome(q: DoubleDouble) -> DoubleDouble {
    let q_4 = q.square().square();
    let q_9 = q_4.square() * q;
    let sixteenth = q_4.hi() * q_4.hi() * q_4.hi() * q_4.hi();
    let theta_3 = ((q_9 + sixteenth.into()) + q_4 + q).scale(2.0) + DoubleDouble::ONE;
    theta_3.square() * DoubleDouble::PI.scale(0.5)
}

/// Carlson's symmetric integral `R_F(x, y, z)` of the first kind; not negative, at most one of them zero.
///
/// By duplication, relative error some parts in 2¹⁰⁰. `[Carlson95]` §2, the series to eleventh order from `[DLMF]` 19.19.7.
#[must_use]
pub fn carlson_rf(x: DoubleDouble, y: DoubleDouble, z: DoubleDouble) -> DoubleDouble {
    // The terms left out are of twelfth order, with a factor below 0.02.
    const SPREAD: f64 = 4e-3;
    let mut arguments = [x, y, z];
    // Each round divides the spread by four; the first few hundred are for arguments of very different size.
    for _ in 0..600 {
        let [x, y, z] = arguments.map(DoubleDouble::hi);
        let mean = (x + y + z) / 3.0;
        if (mean - x).abs().max((mean - y).abs()).max((mean - z).abs()) <= SPREAD * mean {
            break;
        }
        let [x, y, z] = arguments.map(DoubleDouble::sqrt);
        let lambda = x * (y + z) + y * z;
        arguments = arguments.map(|argument| (argument + lambda).scale(0.25));
    }
    let [x, y, z] = arguments;
    let mean = (x + y + z) / DoubleDouble::from(3.0);
    let inverse = mean.recip();
    let (x, y) = (DoubleDouble::ONE - x * inverse, DoubleDouble::ONE - y * inverse);
    let z = -(x + y);
    let (e2, e3) = (x * y - z.square(), x * y * z);
    (DoubleDouble::ONE + rf_series(e2, e3)) * inverse.sqrt()
}

/// What `R_F` of mean 1 has beyond 1, E₁ being 0. Terms from fifth order on are below 1e-14 and need f64 only.
fn rf_series(e2: DoubleDouble, e3: DoubleDouble) -> DoubleDouble {
    const TENTH: DoubleDouble = DoubleDouble::from_parts(1.0 / 10.0, -5.551_115_123_125_783e-18);
    const FOURTEENTH: DoubleDouble = DoubleDouble::from_parts(1.0 / 14.0, 3.965_082_230_804_13e-18);
    const TWENTY_FOURTH: DoubleDouble = DoubleDouble::from_parts(1.0 / 24.0, 2.312_964_634_635_742_7e-18);
    let (p, q) = (e2.hi(), e3.hi());
    let (p2, q2) = (p * p, q * q);
    let fifth_and_sixth = -3.0 / 44.0 * p * q + (3.0 / 104.0 * q2 - 5.0 / 208.0 * p2 * p);
    let seventh_and_eighth = p2 * q / 16.0 + (35.0 / 2176.0 * p2 * p2 - 15.0 / 272.0 * p * q2);
    let ninth = 5.0 / 304.0 * q2 * q - 35.0 / 608.0 * p2 * p * q;
    let tenth_and_eleventh =
        (5.0 / 64.0 * p2 * q2 - 3.0 / 256.0 * p2 * p2 * p) + (315.0 / 5888.0 * p2 * p2 - 35.0 / 736.0 * p * q2) * q;
    let small = fifth_and_sixth + (seventh_and_eighth + (ninth + tenth_and_eleventh));
    e3 * FOURTEENTH - e2 * (TENTH - e2 * TWENTY_FOURTH) + DoubleDouble::from(small)
}
