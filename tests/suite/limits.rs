//! What docs/reliability.md states as limits: at them a scene is planned, beyond them it is refused.

use polhode::scenario::{BodySpec, Method, MomentSpec, Plan, Scenario, ScenarioError, TorqueSpecs};

fn body(name: String, moments: [f64; 3], rates: [f64; 3]) -> BodySpec {
    BodySpec {
        name,
        principal_moments_kg_m2: Some(moments),
        angular_velocity_rad_s: Some(rates),
        ..BodySpec::default()
    }
}

fn scene(duration: f64, every: f64, moments: [f64; 3], rates: [f64; 3]) -> Scenario {
    Scenario {
        duration_s: Some(duration),
        sample_every_s: Some(every),
        body: vec![body(String::new(), moments, rates)],
        ..Scenario::default()
    }
}

const MOMENTS: [f64; 3] = [1.0, 2.0, 2.5];
const RATES: [f64; 3] = [0.1, 2.0, 0.3];

/// What planning refuses, in words.
fn refusal(scenario: &Scenario) -> String {
    match Plan::new(scenario) {
        Err(error @ ScenarioError::Refused(_)) => error.to_string(),
        Err(error) => panic!("{error} is no refusal"),
        Ok(_) => panic!("it is planned"),
    }
}

#[test]
fn the_longest_run_and_the_most_samples() {
    Plan::new(&scene(9e9, 10.0, MOMENTS, RATES)).expect("9e9 s");
    assert!(refusal(&scene(9.1e9, 10.0, MOMENTS, RATES)).contains("longest run"));
    Plan::new(&scene(0.999, 1e-9, MOMENTS, RATES)).expect("samples a nanosecond apart");
    assert!(refusal(&scene(1.0, 0.9e-9, MOMENTS, RATES)).contains("whole nanoseconds"));
    assert!(refusal(&scene(1e9, 0.9, MOMENTS, RATES)).contains("samples: at most 1000000000"));
}

#[test]
fn rates_from_nothing_to_the_most_turns() {
    for rate in [0.0, 5e-324, 1e-200, 1e-9, 1e5] {
        Plan::new(&scene(9e9, 1e9, MOMENTS, [rate; 3])).expect("any rate that leaves a phase");
    }
    let last = std::f64::consts::TAU * 0.99e15 / 9e9;
    Plan::new(&scene(9e9, 1e9, MOMENTS, [0.0, last, 0.0])).expect("0.99e15 turns");
    assert!(refusal(&scene(9e9, 1e9, MOMENTS, [0.0, 1.02 * last, 0.0])).contains("turns: at most 1e15"));
    assert!(refusal(&scene(1e-9, 1e-9, MOMENTS, [0.0, 1.1e60, 0.0])).contains("rad/s: at most 1e60"));
}

#[test]
fn moments_from_the_least_to_the_largest() {
    for size in [1e-60, 1e-12, 1e12, 4e59] {
        let plan = Plan::new(&scene(10.0, 0.1, MOMENTS.map(|moment| moment * size), RATES)).expect("a body");
        let mut run = plan.start().expect("a run");
        let samples = run.next_batch().expect("a finite motion").expect("samples");
        assert!(samples.bodies[0].columns().iter().flatten().all(|value| value.is_finite()), "of {size:e} kg m²");
    }
    for size in [1e-61, 1e60, 1e-310, 1e300] {
        assert!(refusal(&scene(10.0, 0.1, MOMENTS.map(|moment| moment * size), RATES)).contains("1e-60 to 1e60"));
    }
}

#[test]
fn the_most_steps() {
    let by_steps = |step| Scenario { method: Method::Rk4, step_s: Some(step), ..scene(1e6, 10.0, MOMENTS, RATES) };
    Plan::new(&by_steps(1.01e-5)).expect("less than 1e11 steps");
    assert!(refusal(&by_steps(0.99e-5)).contains("at most 1e11"));
    let mut driven = scene(1.0, 0.1, MOMENTS, RATES);
    for (moment, is_possible) in [(1e9, true), (1e40, false), (1e300, false)] {
        let moment = MomentSpec { moment_n_m: [moment, 0.0, 1.0], start_s: None, end_s: None };
        driven.body[0].torque = TorqueSpecs { constant_body: vec![moment], ..TorqueSpecs::default() };
        if is_possible {
            Plan::new(&driven).expect("hours at most");
        } else {
            assert!(refusal(&driven).contains("at most 1e11"));
        }
    }
}

/// As many as a recording can name.
#[test]
fn the_most_bodies() {
    let scene = |count: usize| {
        let bodies = (0..count).map(|number| body(format!("body_{number}"), MOMENTS, RATES)).collect();
        Scenario { body: bodies, ..scene(0.1, 0.1, MOMENTS, RATES) }
    };
    let plan = Plan::new(&scene(65_535)).expect("a scene");
    let mut run = plan.start().expect("a run");
    let samples = run.next_batch().expect("a finite motion").expect("samples");
    assert_eq!((samples.bodies.len(), samples.len()), (65_535, 2));
    assert!(refusal(&scene(65_536)).contains("65536 bodies: at most 65535"));
}

/// As many as the text of the scene holds.
#[test]
fn a_thousand_loads() {
    let mut loaded = scene(1.0, 0.5, MOMENTS, RATES);
    let moment =
        |start: f64| MomentSpec { moment_n_m: [0.1, 0.0, 0.0], start_s: Some(start), end_s: Some(start + 1e-4) };
    let constant_body = (0..1000).map(|number| moment(1e-3 * f64::from(number))).collect();
    loaded.body[0].torque = TorqueSpecs { constant_body, ..TorqueSpecs::default() };
    let plan = Plan::new(&loaded).expect("a plan");
    assert_eq!(plan.bodies[0].problem.loads.len(), 1000);
    let mut run = plan.start().expect("a run");
    let samples = run.next_batch().expect("a finite motion").expect("samples");
    assert_eq!(samples.len(), 3);
}

/// Of its text; more is not even read, as a file may have no end.
#[cfg(feature = "serde")]
#[test]
fn the_largest_scene() {
    const MOST: usize = 16 << 20;
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("large.toml");
    let mut text = "# a comment\n".to_owned();
    text += "duration_s = 1.0\nsample_every_s = 0.5\n[[body]]\nprincipal_moments_kg_m2 = [1, 2, 2.5]\n#";
    text += &"-".repeat(MOST - text.len());
    std::fs::write(&path, &text).expect("room");
    let scenario = Scenario::read(&path, &[]).expect("a scene of 16 MiB");
    Plan::new(&scenario).expect("a plan");
    std::fs::write(&path, text + "-").expect("room");
    let refusal = Scenario::read(&path, &[]).expect_err("a byte more").to_string();
    assert!(refusal.contains("larger than 16777216 bytes"), "{refusal}");
    #[cfg(unix)]
    assert!(Scenario::read("/dev/zero".as_ref(), &[]).is_err(), "a file without end");
}

/// Coils are on their limit at first, which takes few steps; then, in a field of 1 T, each step is far below a second.
#[cfg(feature = "serde")]
#[test]
fn trials_of_plans_end_where_a_motion_grows_stiff() {
    let text = polhode::scenario::library::text("detumbling").expect("a scene");
    let changes = ["body.1.torque.b_dot.0.field_t=[1, 0, 0]".to_owned()];
    let scenario = Scenario::parse(text, "detumbling", &changes).expect("a scene");
    // Refused or not is a matter of how far the trial comes; that it ends at all is what is held here.
    if let Ok(plan) = Plan::new(&scenario) {
        let cost = plan.bodies[1].cost(&plan.grid).expect("a trial");
        assert!(cost.is_estimate, "{cost:?}");
    }
}
