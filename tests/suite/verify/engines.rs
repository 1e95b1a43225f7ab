//! What physics engines really wrote (`tests/foreign`), held against physics.

use std::path::Path;

use polhode::comparison::verify::{Cause, Verdict, Verification, verify};
use polhode::recording::foreign::{Mapping, observe};
use polhode::scenario::{BodySpec, Plan, Scenario};

/// Steps of the engines, s: of 20 one is recorded.
const STEP: f64 = 1e-3;

fn found(engine: &str, tolerance_rad: f64) -> Verification {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mapping = Mapping::read(&root.join("examples/mappings").join(format!("{engine}.toml"))).expect("a mapping");
    let told = observe(&root.join("tests/foreign").join(format!("{engine}.csv")), &mapping).expect("a table");
    let spec = BodySpec {
        principal_moments_kg_m2: Some([1.0, 2.0, 2.5]),
        angular_velocity_rad_s: Some([0.1, 2.0, 0.2]),
        ..BodySpec::default()
    };
    let scene = Scenario { duration_s: Some(4.0), sample_every_s: Some(1.0), body: vec![spec], ..Scenario::default() };
    let body = Plan::new(&scene).expect("a plan").bodies.remove(0);
    let mut observed = told.bodies[0].clone();
    // The frame is to be found, not told.
    observed.angular_velocity.as_mut().expect("rates").axes = None;
    let found = verify(&observed, Some(&body), told.time_resolution_s, tolerance_rad).expect("verified");
    println!("{found:#?}");
    found
}

/// Each of them steps ω by the gyroscopic term of before, and moves q by the new ω, half a step ahead: what it is, how long
/// the step is and how far q is ahead are read off samples at every 20th step.
#[test]
fn three_engines_step_explicitly_and_their_step_is_seen() {
    for engine in ["mujoco", "pybullet", "drake"] {
        let found = found(engine, 1e-4);
        assert_eq!(found.verdict, Verdict::Wrong, "{engine}");
        let Cause::ExplicitStep { step_s } = found.causes[0].cause else { panic!("{engine}: {:?}", found.causes) };
        assert!((step_s / STEP - 1.0).abs() < 0.02, "{engine}: {step_s}");
        assert_eq!(found.causes.len(), 1, "{engine}: {:?}", found.causes);
        // Drake adds q̇ h and normalises: a few 1e-6 rad in four seconds, and seen.
        match found.habits.as_slice() {
            [habit] if engine == "drake" => {
                let Cause::FirstOrderAttitude { step_s, .. } = habit.cause else { panic!("{habit:?}") };
                assert!((step_s / STEP - 1.0).abs() < 0.05, "{step_s}");
            }
            habits => assert!(habits.is_empty() && engine != "drake", "{engine}: {habits:?}"),
        }
        let lag = found.kinematics.expect("both").lag;
        assert!((lag.value / STEP - 0.5).abs() < 0.01, "{engine}: {lag:?}");
    }
}

#[test]
fn an_engine_of_fourth_order_is_clean() {
    let found = found("basilisk", 1e-4);
    assert_eq!(found.verdict, Verdict::Clean);
    assert!(found.laws.expect("of a body").energy_per_turn.value.abs() < 1e-9);
}

#[test]
fn within_a_wider_tolerance_the_same_is_a_habit() {
    let found = found("mujoco", 1e-2);
    assert_eq!(found.verdict, Verdict::Clean);
    assert!(matches!(found.habits[0].cause, Cause::ExplicitStep { .. }), "{:?}", found.habits);
}
