use nalgebra::Vector3;
use polhode::comparison::verify::{Cause, Rate, Rotation, Verdict, Verification};
use polhode::scenario::{MomentSpec, PlannedBody, TorqueSpecs};

use super::engine::{Engine, Gyroscopic, MOMENTS, Turn, book, causes, verified};

/// s: some ten turns.
const DURATION: f64 = 15.0;

fn free(engine: &Engine) -> Verification {
    let found = verified(&engine.record(DURATION), Some(&book(TorqueSpecs::default())));
    assert_eq!(found.verdict, Verdict::Wrong);
    found
}

fn first(found: &Verification) -> &Cause {
    &found.causes.first().expect("a cause").cause
}

#[test]
fn a_missing_gyroscopic_term() {
    let found = free(&Engine { gyroscopic: Gyroscopic::Missing, ..Engine::default() });
    assert_eq!(causes(&found), ["missing_gyroscopic_term"]);
    assert!(found.causes[0].share > 0.999);
}

#[test]
fn explicit_steps_at_first_order() {
    for step in [1.0 / 60.0, 1.0 / 240.0, 1.0 / 1000.0] {
        let found = free(&Engine { step, ..Engine::default() });
        let Cause::ExplicitStep { step_s } = *first(&found) else { panic!("{:?}", found.causes) };
        assert!((step_s / step - 1.0).abs() < 0.1, "{step_s} is not {step}");
        let gain = found.laws.expect("of a body").energy_per_turn;
        assert!(gain.is_seen() && gain.value > 0.0, "{gain:?}");
    }
}

#[test]
fn explicit_steps_of_which_a_few_are_recorded() {
    let found = free(&Engine { step: 1e-3, every: 10, ..Engine::default() });
    let Cause::ExplicitStep { step_s } = *first(&found) else { panic!("{:?}", found.causes) };
    assert!((step_s / 1e-3 - 1.0).abs() < 0.1, "{step_s}");
}

#[test]
fn an_implicit_gyroscopic_step() {
    let found = free(&Engine { gyroscopic: Gyroscopic::Implicit, ..Engine::default() });
    assert!(matches!(first(&found), Cause::ImplicitStep { .. }), "{:?}", found.causes);
    assert!(found.laws.expect("of a body").energy_per_turn.value < 0.0);
}

#[test]
fn damping_that_engines_have_by_default() {
    let exact_but_damped = Engine { step: 1e-4, every: 40, damping: 0.05, ..Engine::default() };
    let found = free(&exact_but_damped);
    let Cause::Damping { rate } = *first(&found) else { panic!("{:?}", found.causes) };
    assert!((rate / 0.05 - 1.0).abs() < 0.01, "{rate}");
}

#[test]
fn no_gyroscopic_term_and_damping() {
    let engine = Engine { gyroscopic: Gyroscopic::Missing, damping: 0.05, ..Engine::default() };
    assert_eq!(causes(&free(&engine)), ["missing_gyroscopic_term", "damping"]);
}

#[test]
fn rates_in_the_body_that_turn_the_attitude_as_if_in_the_world() {
    let found = free(&Engine { turn: Turn::WrongSide, ..Engine::default() });
    assert_eq!(first(&found).name(), "wrong_frame");
}

#[test]
fn moments_in_another_order() {
    let [a, b, c] = MOMENTS;
    for (moments, order) in [([b, a, c], [1, 0, 2]), ([c, b, a], [2, 1, 0]), ([b, c, a], [1, 2, 0])] {
        let found = free(&Engine { moments, step: 1e-4, every: 50, ..Engine::default() });
        assert_eq!(*first(&found), Cause::PermutedMoments { order });
    }
}

#[test]
fn the_moments_of_another_body() {
    let found = free(&Engine { moments: [0.003, 0.0042, 0.006], step: 1e-4, every: 50, ..Engine::default() });
    let Cause::OtherInertia { ratios } = *first(&found) else { panic!("{:?}", found.causes) };
    for (ratio, due) in ratios.into_iter().zip([0.5, 0.7, 1.0]) {
        assert!((ratio - due).abs() < 1e-2, "{ratios:?}");
    }
}

#[test]
fn attitudes_stepped_at_first_order() {
    // ω all but exact, so that only the attitude's step is left.
    let body = book(TorqueSpecs::default());
    for step in [1.0 / 60.0, 1.0 / 240.0] {
        let mut observed = super::engine::exact(&body, &super::engine::evenly(1500, step));
        super::engine::step_attitudes(&mut observed, step);
        let found = verified(&observed, Some(&body));
        assert_eq!(found.verdict, Verdict::Wrong);
        let Cause::FirstOrderAttitude { step_s, .. } = *first(&found) else { panic!("{:?}", found.causes) };
        assert!((step_s / step - 1.0).abs() < 0.1, "{step_s} is not {step}");
    }
}

#[test]
fn a_step_of_first_order_in_both_is_told_by_both() {
    let found = free(&Engine { turn: Turn::NormalisedQuaternion, step: 1.0 / 60.0, ..Engine::default() });
    assert_eq!(causes(&found), ["explicit_step", "first_order_attitude"]);
    let update = found.kinematics.expect("both").update.expect("every step is recorded");
    assert_eq!(update.rotation, Rotation::NormalisedQuaternion);
    assert_eq!(update.rate, Rate::After);
}

#[test]
fn a_quaternion_that_nobody_normalises() {
    let found = free(&Engine { turn: Turn::Quaternion, ..Engine::default() });
    assert_eq!(first(&found).name(), "not_normalised");
}

/// Forty thousand roundings lead 3e-4 rad astray, less than the tolerance, and look like no method's error.
#[test]
fn arithmetic_of_32_bits_is_not_taken_for_damping_or_steps() {
    let body = book(TorqueSpecs::default());
    let found = verified(&super::engine::rounded_on_the_way(&body, 40_000, 5e-4), Some(&body));
    assert_eq!(found.verdict, Verdict::Clean, "{:?}", found.reasons);
    assert!(found.causes.is_empty(), "{:?}", found.causes);
    assert!(found.distance.expect("of attitudes").worst_rad > 1e-4, "rounding adds up");
}

fn constant_in_body(moment: [f64; 3]) -> PlannedBody {
    let spec = MomentSpec { moment_n_m: moment, start_s: None, end_s: None };
    book(TorqueSpecs { constant_body: vec![spec], ..TorqueSpecs::default() })
}

fn constant_in_world(moment: [f64; 3]) -> PlannedBody {
    let spec = MomentSpec { moment_n_m: moment, start_s: None, end_s: None };
    book(TorqueSpecs { constant_world: vec![spec], ..TorqueSpecs::default() })
}

const TORQUE: [f64; 3] = [0.002, -0.003, 0.001];

fn fine() -> Engine {
    Engine { step: 1e-4, every: 50, ..Engine::default() }
}

#[test]
fn torques_that_act_otherwise() {
    let torque = Vector3::from(TORQUE);
    let cases = [
        (Engine { torque_in_world: torque, ..fine() }, constant_in_body(TORQUE), "torque_in_wrong_frame"),
        (Engine { torque_in_body: torque, ..fine() }, constant_in_world(TORQUE), "torque_in_wrong_frame"),
        (fine(), constant_in_world(TORQUE), "torque_missing"),
        (Engine { torque_in_world: -torque, ..fine() }, constant_in_world(TORQUE), "torque_reversed"),
        (Engine { torque_in_world: 1.5 * torque, ..fine() }, constant_in_world(TORQUE), "torque_scaled"),
    ];
    for (engine, body, cause) in cases {
        let found = verified(&engine.record(DURATION), Some(&body));
        assert_eq!(found.verdict, Verdict::Wrong);
        assert_eq!(first(&found).name(), cause, "{:?}", found.causes);
    }
}

#[test]
fn a_tensor_that_does_not_turn_with_the_body() {
    let engine = Engine { gyroscopic: Gyroscopic::NotRotated, torque_in_world: Vector3::from(TORQUE), ..fine() };
    let found = verified(&engine.record(DURATION), Some(&constant_in_world(TORQUE)));
    assert_eq!(first(&found).name(), "inertia_not_rotated", "{:?}", found.causes);
}

#[test]
fn a_limit_to_the_rate() {
    let torque = [0.0, 0.0, 0.02];
    let engine = Engine { torque_in_body: Vector3::from(torque), fastest: 7.0, ..fine() };
    let found = verified(&engine.record(DURATION), Some(&constant_in_body(torque)));
    let Cause::ClampedRate { limit } = *first(&found) else { panic!("{:?}", found.causes) };
    assert!((limit - 7.0).abs() < 1e-9, "{limit}");
}
