//! What physics engines really wrote (the scripts are beside the files), read by the mappings that come with this crate.

use std::path::{Path, PathBuf};

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::dynamics::Problem;
use polhode::propagation::{FreeRotation, States};
use polhode::recording::foreign::{Mapping, observe};
use polhode::recording::{Axes, Observed};

use crate::motions::run;

fn of_engine(engine: &str) -> Observed {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let table: PathBuf = root.join("tests/foreign").join(format!("{engine}.csv"));
    let mapping = Mapping::read(&root.join("examples/mappings").join(format!("{engine}.toml"))).expect("a mapping");
    let mut found = observe(&table, &mapping).unwrap_or_else(|error| panic!("{engine}: {error}"));
    assert_eq!((found.bodies.len(), found.start_ns), (1, 0), "{engine}");
    found.bodies.remove(0)
}

/// The body of the scripts, exactly: moments 1, 2, 2.5 kg m², ω = (0.1, 2, 0.2) rad/s, axes along those of the world.
fn exact(times: &[f64]) -> States {
    let problem = Problem {
        moments: PrincipalMoments::new([1.0, 2.0, 2.5]).expect("a body"),
        mass: None,
        initial: State {
            attitude: Attitude::new([1.0, 0.0, 0.0, 0.0]).expect("a unit quaternion"),
            angular_velocity: AngularVelocity::new([0.1, 2.0, 0.2]).expect("finite"),
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
        },
        loads: Vec::new(),
        gravity: Vector3::zeros(),
        wants_attitude: true,
        wants_translation: false,
    };
    run(FreeRotation::new(&problem).expect("a free body"), times)
}

/// How far an engine is from the truth at the most: attitude, rad, and ω in the axes that the mapping says, rad/s; and
/// how far ω would be in the other axes.
fn errors(engine: &str) -> [f64; 3] {
    let found = of_engine(engine);
    let (attitude, rates) = (found.attitude.expect("told"), found.angular_velocity.expect("told"));
    assert_eq!(attitude.times_s.len(), 201, "{engine}");
    let states = exact(&attitude.times_s);
    let mut errors = [0.0_f64; 3];
    for index in 0..attitude.times_s.len() {
        let [w, x, y, z] = [0, 1, 2, 3].map(|part| attitude.columns[part][index]);
        let turn = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
        let [w, x, y, z] = [0, 1, 2, 3].map(|part| states.attitude[part][index]);
        let truth = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        let in_body = Vector3::from([0, 1, 2].map(|axis| states.angular_velocity[axis][index]));
        let told = Vector3::from([0, 1, 2].map(|axis| rates.columns[axis][index]));
        let in_world = truth * in_body;
        let (right, wrong) = if rates.axes == Some(Axes::Body) { (in_body, in_world) } else { (in_world, in_body) };
        let now = [turn.angle_to(&truth), (told - right).norm(), (told - wrong).norm()];
        errors = [0, 1, 2].map(|part| errors[part].max(now[part]));
    }
    errors
}

/// Bounds are twice what was found with the versions in the scripts, over four seconds: the engines' own errors at steps of
/// 1 ms (Basilisk: of 20 ms, of fourth order). A wrong order, sense or frame in a mapping would show as 1 rad or 1 rad/s.
#[test]
fn engines_are_read_as_they_mean_it() {
    let bounds =
        [("mujoco", 1.7e-3, 5e-3), ("pybullet", 1.7e-3, 2.1e-3), ("drake", 1.7e-3, 2.1e-3), ("basilisk", 5.2e-9, 8e-9)];
    for (engine, most_rad, most_rad_s) in bounds {
        let [attitude, rates, in_other_axes] = errors(engine);
        assert!(attitude < most_rad, "{engine}: {attitude} rad");
        assert!(rates < most_rad_s, "{engine}: {rates} rad/s");
        assert!(in_other_axes > 1.8, "{engine}: ω in other axes is off by {in_other_axes} rad/s only");
    }
}

/// What the documentation shows is what was run.
#[test]
fn the_scripts_are_those_of_the_documentation() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join("docs/recordings_of_others.md")).expect("there");
    for engine in ["mujoco", "pybullet", "drake", "basilisk"] {
        let script = root.join("tests/foreign").join(format!("{engine}_free_body.py"));
        let script = std::fs::read_to_string(script).expect("there");
        assert!(text.contains(&format!("```python\n{script}```\n")), "{engine}: another script than was run");
    }
}
