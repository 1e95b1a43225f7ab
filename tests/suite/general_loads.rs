//! Loads that go by a tape of operations: against the recurrences laid out by hand, closed forms and laws.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use polhode::dynamics::formula::Expression;
use polhode::dynamics::{FormulaLoad, FormulaPlace, General, GeneralLoad, Load, Problem, Torque, Window};
use polhode::propagation::{Dop853, PreciseTaylor, States, Taylor, attitude_distance};

use crate::motions::{MOMENTS, RATES, every_torque, grid, problem, row, run};

/// The tightest tolerance of a step.
const TIGHTEST: f64 = 1e-16;

fn general(kind: General) -> Torque {
    Torque::General(Arc::new(GeneralLoad::new(kind)))
}

/// A moment by formulae, in body axes that are principal axes.
fn formula(texts: [&str; 3], in_world: bool) -> Torque {
    general(General::Formula(FormulaLoad {
        components: texts.map(|text| Expression::read(text).expect("a formula")),
        in_world,
        place: FormulaPlace::Moment,
        body_from_principal: UnitQuaternion::identity(),
    }))
}

/// A load that does nothing, and sends all others by the tape.
fn nothing() -> Torque {
    formula(["0", "0", "0"], false)
}

/// The largest difference of attitudes, rad, and of rates, rad/s.
fn apart(a: &States, b: &States) -> f64 {
    let rates = a.angular_velocity.iter().zip(&b.angular_velocity).flat_map(|(a, b)| a.iter().zip(b));
    rates.map(|(a, b)| (a - b).abs()).fold(attitude_distance(a, b), f64::max)
}

/// Every listed load by the tape moves the body as by the recurrences laid out by hand: in f64 to the rounding of both, in
/// double-double to 1e-28.
#[test]
fn the_tape_moves_bodies_as_the_recurrences_do() {
    let times = grid(10.0, 20);
    for (name, torque) in every_torque() {
        for wants_translation in [false, true] {
            let by_hand = Problem { wants_translation, ..problem(MOMENTS, RATES, &[torque.clone()]) };
            let by_tape = Problem { wants_translation, ..problem(MOMENTS, RATES, &[torque.clone(), nothing()]) };
            let [hand, tape] =
                [&by_hand, &by_tape].map(|problem| run(Taylor::new(problem, TIGHTEST).expect("covered"), &times));
            let off = apart(&hand, &tape);
            assert!(off < 2e-14, "{name}: {off:e}");
            if wants_translation {
                for i in 0..times.len() {
                    let (a, b) = (Vector3::from(row(&hand.position, i)), Vector3::from(row(&tape.position, i)));
                    assert!((a - b).norm() <= 1e-14 * a.norm(), "{name}: {} m", (a - b).norm());
                }
            }
            let [hand, tape] = [&by_hand, &by_tape].map(|problem| {
                PreciseTaylor::new(problem).expect("covered").at(3.0).expect("finite").expect("within reach")
            });
            let pairs = hand.attitude.iter().zip(tape.attitude);
            let pairs = pairs.chain(hand.angular_velocity.iter().zip(tape.angular_velocity));
            let off = pairs.map(|(a, b)| (*a - b).abs().hi()).fold(0.0, f64::max);
            assert!(off < 1e-28, "{name}: {off:e} in double-double");
        }
    }
}

/// A body at rest under τ = 0.1 sin 2t about one axis: ω = 0.05 (1 − cos 2t)/I, φ = 0.05 (t − sin 2t / 2)/I.
#[test]
fn a_formula_of_time_turns_a_body_by_its_integral() {
    let body = problem(MOMENTS, [0.0; 3], &[formula(["0", "0", "0.1*sin(2*t)"], false)]);
    let times = grid(20.0, 40);
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &times);
    for (i, t) in times.iter().enumerate() {
        let exact = 0.05 * (1.0 - libm::cos(2.0 * t)) / MOMENTS[2];
        let [x, y, z] = row(&states.angular_velocity, i);
        assert!((z - exact).abs() < 1e-16 && x == 0.0 && y == 0.0, "{z} for {exact} rad/s at {t} s");
    }
}

/// Formulae that say what listed loads say: damping, the moment of a force constant in the world, a gravity gradient.
#[test]
fn formulae_of_the_motion_are_the_loads_they_describe() {
    let couple = ["-1.6*r33*(-0.2) - 0.3*(-1.6)*r32", "0.3*(-1.6)*r31 - 0.1*(-1.6)*r33", "0.1*(-1.6)*r32 + 0.2*(-1.6)*r31"];
    let arm = Vector3::new(0.1, -0.2, 0.3);
    let cases = [
        (Torque::LinearDamping { coefficient: 0.2 }, formula(["-0.2*wx", "-0.2*wy", "-0.2*wz"], false)),
        (Torque::ConstantWorld { moment: Vector3::new(0.25, 0.5, -1.0) }, formula(["1/4", "2^-1", "-1"], true)),
        (Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -1.6), arm }, formula(couple, false)),
    ];
    let times = grid(10.0, 20);
    for (listed, formula) in cases {
        let [a, b] = [&listed, &formula].map(|torque| {
            let problem = problem(MOMENTS, RATES, std::slice::from_ref(torque));
            run(Taylor::new(&problem, TIGHTEST).expect("covered"), &times)
        });
        let off = apart(&a, &b);
        assert!(off < 1e-14, "{listed:?}: {off:e}");
    }
}

/// A moment with corners, |sin 3t| and a bound on what depends on ω: the steps end on the corners, so that f64 keeps to the
/// motion in double-double to rounding, wherever the samples lie; DOP853, which steps across corners, tells the same motion.
#[test]
fn corners_are_stepped_to_and_not_across() {
    let corners = formula(["0.3*abs(sin(3*t))", "max(-0.1, min(0.1, -wy))", "0.2*min(cos(t), 0.3) - 0.05*abs(wx)"], false);
    let body = problem(MOMENTS, RATES, &[corners]);
    let times = grid(12.0, 30);
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &times);
    let mut precise = PreciseTaylor::new(&body).expect("covered");
    for (i, time) in times.iter().enumerate() {
        let exact = precise.at(*time).expect("finite").expect("within reach");
        let rates = row(&states.angular_velocity, i);
        for (found, exact) in rates.iter().zip(exact.angular_velocity) {
            assert!((found - exact.hi()).abs() < 1e-14, "{found} for {} at {time} s", exact.hi());
        }
    }
    let other = run(Dop853::new(&body, 1e-12).expect("covered"), &times);
    let off = apart(&states, &other);
    assert!(off < 1e-8, "{off:e}");
    let last = run(Taylor::new(&body, TIGHTEST).expect("covered"), &times[times.len() - 1..]);
    for (found, alone) in states.angular_velocity.iter().zip(&last.angular_velocity) {
        assert_eq!(found.last(), alone.last(), "a sample depends on those before it");
    }
}

/// A peak a thousandth of its distance wide, and zero in f64 where the run starts, is not stepped over.
#[test]
fn a_distant_peak_is_met() {
    let body = problem(MOMENTS, [0.0; 3], &[formula(["0", "0", "exp(-((t-50)*20)^2)"], false)]);
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &[100.0]);
    let exact = std::f64::consts::PI.sqrt() / 20.0 / MOMENTS[2];
    let found = states.angular_velocity[2][0];
    assert!((found - exact).abs() < 2e-15, "{found} for {exact} rad/s");
}

/// Windows hold for formulae as for all loads: ω gained is the integral from edge to edge.
#[test]
fn windows_cut_formulae_exactly() {
    let torque = formula(["0", "0", "t"], false);
    let mut body = problem(MOMENTS, [0.0; 3], &[]);
    body.loads = vec![Load { torque, window: Window { start: 1.3, end: 2.9 } }];
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &[0.7, 5.0]);
    let exact = 0.5 * (2.9 * 2.9 - 1.3 * 1.3) / MOMENTS[2];
    assert_eq!(states.angular_velocity[2][0], 0.0);
    assert!((states.angular_velocity[2][1] - exact).abs() < 1e-15);
}
