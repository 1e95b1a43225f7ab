//! Series of tapes: against known series, in f64 and in double-double, and where branches change.

use polhode::numerics::{DoubleDouble, Expansion, Node, Scalar, Tape};

/// The order of the series.
const ORDER: usize = 24;

/// The coefficients of what `build` makes of t, at t = `start`.
fn series<F: Scalar>(start: f64, build: impl Fn(&mut Tape, Node) -> Node) -> (Vec<F>, Tape, Expansion<F>) {
    let mut tape = Tape::new(1);
    let t = tape.input(0);
    let node = build(&mut tape, t);
    tape.want(node);
    let mut expansion = Expansion::new(&tape, ORDER);
    expansion.set(0, 0, F::from(start));
    expansion.set(0, 1, F::from(1.0));
    expansion.expand(&tape, ORDER);
    (expansion.output(&tape, 0).to_vec(), tape, expansion)
}

fn value<F: Scalar>(coefficients: &[F], sigma: f64) -> F {
    coefficients.iter().rev().fold(F::from(0.0), |sum, c| sum * F::from(sigma) + *c)
}

type Build = fn(&mut Tape, Node) -> Node;
type Real = fn(f64) -> f64;

/// Functions and their tapes, smooth near 0.7.
fn functions() -> Vec<(&'static str, Real, Build)> {
    vec![
        ("sin", libm::sin, |tape, t| tape.sine_cosine(t).0),
        ("cos", libm::cos, |tape, t| tape.sine_cosine(t).1),
        ("exp", libm::exp, Tape::exponential),
        ("ln", libm::log, Tape::logarithm),
        ("sqrt", libm::sqrt, Tape::root),
        ("atan", libm::atan, Tape::arctangent),
        (
            "1/t",
            |t| 1.0 / t,
            |tape, t| {
                let one = tape.constant(1.0);
                tape.quotient(one, t)
            },
        ),
        ("t^7", |t| t * t * t * t * t * t * t, |tape, t| tape.power(t, 7)),
        ("abs", |t| t, Tape::magnitude),
    ]
}

/// A series of order 24 at a fifth of its radius has the function's value there, to rounding.
#[test]
fn series_have_the_values_of_their_functions() {
    for (name, function, build) in functions() {
        let (coefficients, ..) = series::<f64>(0.7, build);
        for sigma in [-0.1, 0.05, 0.1] {
            let (found, exact) = (value(&coefficients, sigma), function(0.7 + sigma));
            assert!((found - exact).abs() < 1e-15 * exact.abs().max(1.0), "{name} at {sigma}: {found} for {exact}");
        }
    }
}

/// The identities of each function with its inverse hold in all 106 bits, along the whole series.
#[test]
fn series_in_double_double_have_thirty_digits() {
    let inverses: [(&str, Build); 4] = [
        ("exp ln", |tape, t| {
            let logarithm = tape.logarithm(t);
            tape.exponential(logarithm)
        }),
        ("root of square", |tape, t| {
            let square = tape.product(t, t);
            tape.root(square)
        }),
        ("tan atan", |tape, t| {
            let angle = tape.arctangent(t);
            let (sine, cosine) = tape.sine_cosine(angle);
            tape.quotient(sine, cosine)
        }),
        ("t (sin² + cos²)", |tape, t| {
            let (sine, cosine) = tape.sine_cosine(t);
            let squares = [sine, cosine].map(|node| tape.product(node, node));
            let one = tape.sum(squares[0], squares[1]);
            tape.product(t, one)
        }),
    ];
    for (name, build) in inverses {
        let (coefficients, ..) = series::<DoubleDouble>(0.7, build);
        let found = value(&coefficients, 0.05);
        let off = (found - (DoubleDouble::from(0.7) + DoubleDouble::from(0.05))).abs().hi();
        assert!(off < 1e-30, "{name} is {off:e} off");
    }
}

/// |t − 1| leaves its branch at σ = 0.3 of the way from 0.7, and a look at 8 (σ − 0.3)² + 1e-9 finds no crossing.
#[test]
fn branches_are_left_where_their_guards_change_sign() {
    let (_, tape, expansion) = series::<f64>(0.7, |tape, t| {
        let one = tape.constant(1.0);
        let difference = tape.difference(t, one);
        tape.magnitude(difference)
    });
    let found = expansion.first_switch(&tape, ORDER, 1.0).expect("it changes sign");
    assert!((found - 0.3).abs() < 1e-12, "{found}");
    let (_, tape, expansion) = series::<f64>(0.7, |tape, t| {
        let (one, gap) = (tape.constant(1.0), tape.constant(1e-9));
        let difference = tape.difference(t, one);
        let square = tape.product(difference, difference);
        let above = tape.sum(square, gap);
        tape.magnitude(above)
    });
    assert_eq!(expansion.first_switch(&tape, ORDER, 1.0), None, "a near miss is no crossing");
}

/// Two crossings closer together than any spacing of looks: 1e-4 of the way apart, the first is told.
#[test]
fn short_visits_to_the_other_branch_are_seen() {
    let (_, tape, expansion) = series::<f64>(0.0, |tape, t| {
        let (near, far) = (tape.constant(0.123_4), tape.constant(0.123_5));
        let (a, b) = (tape.difference(t, near), tape.difference(t, far));
        let product = tape.product(a, b);
        tape.magnitude(product)
    });
    let found = expansion.first_switch(&tape, ORDER, 1.0).expect("it changes sign twice");
    assert!((found - 0.123_4).abs() < 2e-9, "{found}");
}

/// |t| at t = 0 goes on along +t, though the sign of its guard says nothing there.
#[test]
fn a_guard_at_zero_is_told_by_its_slope() {
    for slope in [1.0, -1.0] {
        let (coefficients, ..) = series::<f64>(0.0, |tape, t| {
            let factor = tape.constant(slope);
            let product = tape.product(factor, t);
            tape.magnitude(product)
        });
        assert_eq!(coefficients[1], 1.0, "|{slope} t|");
    }
}
