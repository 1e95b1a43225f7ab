//! Double-double and the functions built on it, against digits from mpmath (60 figures) and from `[Carlson95]`.

use polhode::numerics::{
    Compensated, DoubleDouble, FlipSum, Jacobi, NomeSeries, Phase, Theta, carlson_rf, complete_k, so3, two_prod,
    two_sum,
};

use crate::reference::decimal;

/// A few parts in 2¹⁰⁴.
const ARITHMETIC_LIMIT: f64 = 4e-31;
/// Of the functions.
const FUNCTION_LIMIT: f64 = 2e-30;
/// Of a theta series in f64.
const SERIES_LIMIT: f64 = 4e-16;

fn relative_error(found: DoubleDouble, digits: &str) -> f64 {
    let truth = decimal(digits);
    ((found - truth) / truth).abs().hi()
}

fn assert_close(found: DoubleDouble, digits: &str, limit: f64) {
    let error = relative_error(found, digits);
    assert!(error <= limit, "{found:?} is {error:e} off {digits}");
}

fn dd(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

#[test]
fn error_free_transformations_lose_nothing() {
    assert_eq!(two_sum(1.0, 2.0_f64.powi(-80)), (1.0, 2.0_f64.powi(-80)));
    assert_eq!(two_sum(2.0_f64.powi(-80), 1.0), (1.0, 2.0_f64.powi(-80)));
    // (1 + 2⁻⁵²)² = 1 + 2⁻⁵¹ + 2⁻¹⁰⁴
    let next = 1.0 + f64::EPSILON;
    assert_eq!(two_prod(next, next), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
    for (a, b) in [(0.1, 0.3), (1e100, -7.7e-30), (std::f64::consts::PI, 1.0 / 3.0)] {
        let product = a * b;
        assert_eq!(two_prod(a, b), (product, a.mul_add(b, -product)));
    }
}

#[test]
fn arithmetic_holds_104_bits() {
    assert_close(dd(2.0).sqrt(), "1.414213562373095048801688724209698", ARITHMETIC_LIMIT);
    assert_close(dd(1.0) / dd(3.0), "0.3333333333333333333333333333333333", ARITHMETIC_LIMIT);
    assert_close(dd(2.0).sqrt().square(), "2.000000000000000000000000000000000", ARITHMETIC_LIMIT);
    assert_close(dd(1.0) / dd(7.0) * dd(7.0), "1.000000000000000000000000000000000", ARITHMETIC_LIMIT);
    assert!((dd(1.0) + dd(1e-40) - dd(1.0)).hi().abs() < 1e-31);
    assert!(DoubleDouble::from_parts(1.0, 1e-20) > dd(1.0) && DoubleDouble::from_parts(1.0, -1e-20) < dd(1.0));
    assert_eq!(dd(0.0).sqrt(), DoubleDouble::ZERO);
    assert!(dd(-1.0).sqrt().hi().is_nan());
}

#[test]
fn exponential_and_circular_functions() {
    assert_close(dd(1.0).exp(), "2.718281828459045235360287471352662", FUNCTION_LIMIT);
    assert_close(dd(-31.25).exp(), "2.681003867781803222154873116390598e-14", 10.0 * FUNCTION_LIMIT);
    assert_close(dd(1.0 / 1024.0).exp(), "1.000977039492416535242845292611607", FUNCTION_LIMIT);
    assert_eq!(dd(-1000.0).exp(), DoubleDouble::ZERO);
    for (x, sinh, cosh) in [
        (0.125, "0.1253257752411154569820575422913716", "1.007822677825710859846949685520422"),
        (3.5, "16.5426272876349976249567315290125", "16.57282467105731612569651782137612"),
    ] {
        let (found_sinh, found_cosh) = dd(x).sinh_cosh();
        assert_close(found_sinh, sinh, FUNCTION_LIMIT);
        assert_close(found_cosh, cosh, FUNCTION_LIMIT);
    }
    assert_close(dd(2.0_f64.powi(-60)).sinh_cosh().0, "8.673617379884035472059622406959534e-19", FUNCTION_LIMIT);
    let (sin, cos) = dd(0.75).sin_cos();
    assert_close(sin, "0.6816387600233341667332419527798939", FUNCTION_LIMIT);
    assert_close(cos, "0.7316888688738208863118387530000845", FUNCTION_LIMIT);
}

#[test]
fn elliptic_integrals_of_the_first_kind() {
    assert_close(complete_k(dd(1.0)), "1.570796326794896619231321691639751", FUNCTION_LIMIT);
    assert_close(complete_k(dd(0.5)), "2.156515647499643235438674998800322", FUNCTION_LIMIT);
    assert_close(complete_k(dd(1e-3)), "8.294051463615439964498908281942729", FUNCTION_LIMIT);
    assert_close(complete_k(dd(2.0_f64.powi(-80))), "56.83806880591551537221303395957048", FUNCTION_LIMIT);
    let small = 2.0_f64.powi(-40);
    for (x, y, z, digits) in [
        (1.0, 2.0, 0.0, "1.31102877714605990523241979494556"), // the first three: [Carlson95] §3
        (0.5, 1.0, 0.0, "1.85407467730137191843385034719526"),
        (2.0, 3.0, 4.0, "0.5840828416771517066928491689256679"),
        (0.0, 2.0_f64.powi(-60), 1.0, "22.18070977791824990594426219786244"),
        (small, 0.5 * small, 1.0, "14.71443797558406466737660375044685"),
        (1.0, 1.0, 1.0, "1.0"),
    ] {
        assert_close(carlson_rf(dd(x), dd(y), dd(z)), digits, FUNCTION_LIMIT);
    }
}

#[test]
fn phases_come_off_exactly_after_any_number_of_turns() {
    // A third of a turn per second, for 10¹⁵ + 1 s: what is left is (10¹⁵ + 1)/3 mod 1 = 2/3, so −1/3.
    let third = Phase { start: DoubleDouble::ZERO, rate: dd(1.0) / dd(3.0) };
    assert!((third.at(1e15 + 1.0).turns() + 1.0 / 3.0).abs() < 1e-16);
    let (sin, cos) = third.at(3e15 + 1.0).sin_cos();
    assert!((sin - 0.75_f64.sqrt()).abs() < 2e-16 && (cos + 0.5).abs() < 2e-16, "{sin} {cos}");
    for eighth in -8..=8 {
        let angle = f64::from(eighth) / 8.0 + 0.01;
        let (sin, cos) = Phase { start: dd(angle), rate: DoubleDouble::ZERO }.at(0.0).sin_cos();
        let (sin_true, cos_true) = libm::sincos(angle * std::f64::consts::TAU);
        assert!((sin - sin_true).abs() < 1e-15 && (cos - cos_true).abs() < 1e-15, "{angle} turns");
    }
}

/// At Q = 1/32, s = 1/4: v in turns, θ₄ and θ₁/2Q^(1/4) at v − i s as re, im, and sn, cn, dn.
#[allow(clippy::unreadable_literal, clippy::excessive_precision, reason = "digits as they are published")]
const THETA: [[f64; 8]; 5] = [
    [0.0, 0.92952632036720661622, 0.0, 0.0, -0.25180927461654062372, 0.0, 1.0, 1.0],
    [
        0.0625,
        0.95016550208512844424,
        -0.0230271349916396309,
        0.39353660981469260495,
        -0.23307603707524410951,
        0.62011310399390334734,
        0.7845124207143226693,
        0.79724061165330447219,
    ],
    [
        0.1875,
        1.0498344979148715558,
        -0.023031618028419583145,
        0.95338529351347536769,
        -0.097412465455113165042,
        0.98403469322443786475,
        0.17797674716289895231,
        0.28700691215299448625,
    ],
    [
        0.40625,
        0.97302768292425591604,
        0.030087745459186817102,
        0.57178237135963414254,
        0.21019612970691163635,
        0.79919289024640974322,
        -0.60107464110507113484,
        0.62827602393071285488,
    ],
    [
        -0.3125,
        1.0498344979148715558,
        -0.023031618028419583145,
        -0.95338529351347536769,
        0.097412465455113165042,
        -0.98403469322443786475,
        -0.17797674716289895231,
        0.28700691215299448625,
    ],
];

#[test]
fn theta_functions_by_either_nome() {
    let (nome, shift) = (dd(1.0 / 32.0), dd(0.25));
    let series = NomeSeries::new(nome, shift);
    // T = −ln Q/π; the sum over flips holds on both sides of T = 1 for a way.
    let inverse_width = DoubleDouble::PI / decimal("3.465735902799726547086160607290883"); // 5 ln 2
    let flips = FlipSum::new(
        (-(DoubleDouble::PI * inverse_width)).exp(),
        inverse_width,
        shift.scale(2.0) * inverse_width / DoubleDouble::PI,
    );
    for [turns, a_re, a_im, b_re, b_im, sn, cn, dn] in THETA {
        let v = Phase { start: dd(turns), rate: DoubleDouble::ZERO }.at(0.0);
        let close = |found: &[f64], truth: &[f64]| {
            let error = found.iter().zip(truth).fold(0.0_f64, |worst, (x, y)| worst.max((x - y).abs()));
            assert!(error <= SERIES_LIMIT, "{error:e} at {turns} turns");
        };
        let (at, near) = (series.place(v), flips.place(v));
        let pair = series.pair(at);
        close(&[pair.a[0], pair.a[1], pair.b[0], pair.b[1]], &[a_re, a_im, b_re, b_im]);
        close(&series.jacobi(at), &[sn, cn, dn]);
        close(&flips.jacobi(near), &[sn, cn, dn]);
        // The other nome leaves out a factor that depends on v, and a constant between a and b.
        let other = flips.pair(near);
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * other.turns);
        let turned = |z: [f64; 2]| [z[0] * cos - z[1] * sin, z[1] * cos + z[0] * sin];
        let (a, b) = (turned(other.a), turned(other.b));
        let at_zero = flips.pair(flips.place(Phase { start: dd(0.0), rate: dd(0.0) }.at(0.0)));
        let a_factor = a_re.hypot(a_im) / a[0].hypot(a[1]);
        let b_factor = a_factor * (THETA[0][4] / at_zero.b[1]) / (THETA[0][1] / at_zero.a[0]);
        close(&[a_factor * a[0], a_factor * a[1], b_factor * b[0], b_factor * b[1]], &[a_re, a_im, b_re, b_im]);
    }
    let difference = series.log_derivative() - flips.log_derivative();
    assert!(difference.hi().abs() < 1e-30, "logarithmic derivatives differ by {:e}", difference.hi());
}

#[test]
fn compensated_sum_keeps_what_rounding_drops() {
    let mut sum = Compensated::new(1.0);
    for _ in 0..1000 {
        sum.add(1e-17);
    }
    sum.add(-1.0);
    assert!((sum.value() - 1e-14).abs() < 1e-28, "{:e}", sum.value());
}

#[test]
fn exponential_of_a_rotation_vector() {
    let axis = nalgebra::Vector3::new(0.48, -0.6, 0.64);
    let turned = so3::exp(&(axis * 1.25));
    assert!((turned.angle() - 1.25).abs() < 4e-16 && (turned.imag() / libm::sin(0.625) - axis).norm() < 4e-16);
    let tiny = so3::exp(&(axis * 1e-12));
    assert!((tiny.imag() - axis * 0.5e-12).norm() < 1e-27);
    assert_eq!(so3::exp(&nalgebra::Vector3::zeros()), nalgebra::UnitQuaternion::identity());
}
