//! States and channels of problems, straight from their propagators, in batches of several sizes.

use nalgebra::{UnitQuaternion, Vector3};
use polhode::body::Attitude;
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::propagation::{
    AxialTorque, BrakedRotation, Coverage, Dop853, FixedStep, FixedStepMethod, FreeRotation, LagrangeTop,
    PreciseTaylor, PropagationError, Propagator, States, Taylor,
};
use polhode::telemetry::{BodySamples, Channel, Derivation};

use super::Hash;
use crate::motions::{MOMENTS, RATES, every_torque, grid, problem};

/// Samples in a batch; the largest takes all at once.
const BATCHES: [usize; 4] = [1, 7, 64, 1000];

type Fresh = Result<Box<dyn Propagator>, PropagationError>;

pub fn lines() -> Vec<String> {
    let mut lines = Vec::new();
    let mut add = |name: &str, problem: &Problem, times: &[f64], fresh: &dyn Fn(&Problem) -> Fresh| {
        let hashes = BATCHES.map(|batch| hash(name, problem, times, fresh, batch));
        lines.push(hashes[0].line(name));
        for (hash, batch) in hashes.iter().zip(BATCHES).skip(1).filter(|(hash, _)| **hash != hashes[0]) {
            lines.push(hash.line(&format!("{name}, by {batch} at a time")));
        }
    };
    let times = grid(20.0, 200);
    for (name, moments, rates, end) in FREE {
        let mut problem = problem(moments, rates, &[]);
        problem.wants_translation = true;
        add(&format!("closed form, {name}"), &problem, &grid(end, 200), &|p| Ok(Box::new(FreeRotation::new(p)?)));
        (problem.wants_attitude, problem.wants_translation) = (false, false);
        let name = format!("closed form, {name}, rates");
        add(&name, &problem, &grid(end, 200), &|p| Ok(Box::new(FreeRotation::new(p)?)));
    }
    for (name, problem) in tops() {
        let name = format!("Lagrange top, {name}");
        add(&name, &problem, &times, &|p| Ok(Box::new(LagrangeTop::new(p)?)));
    }
    for rate in [1e-12, 0.03, 0.7] {
        let problem = problem(MOMENTS, RATES, &[Torque::MomentumBrake { rate }]);
        add(&format!("brake {rate:e}"), &problem, &times, &|p| Ok(Box::new(BrakedRotation::new(p)?)));
    }
    for (name, problem) in axial() {
        add(&format!("axial torque, {name}"), &problem, &times, &|p| Ok(Box::new(AxialTorque::new(p)?)));
    }
    for (name, problem) in loaded() {
        for tolerance in [1e-16, 1e-7] {
            let name = format!("Taylor {tolerance:e}, {name}");
            add(&name, &problem, &times, &|p| Ok(Box::new(Taylor::new(p, tolerance)?)));
        }
        let name = format!("DOP853, {name}");
        add(&name, &problem, &times, &|p| Ok(Box::new(Dop853::new(p, 1e-10)?)));
    }
    for method in FixedStepMethod::ALL {
        for (name, problem) in loaded() {
            let is_covered = problem.loads.is_empty() || method.information().coverage != Coverage::TorqueFree;
            let is_telling = ["nothing", "force world", "everything, in windows"].contains(&name.as_str());
            if is_covered && is_telling {
                let name = format!("{}, {name}", method.information().name);
                let times = grid(2.0, 100);
                add(&name, &problem, &times, &|p| Ok(Box::new(FixedStep::new(p, method, 0.01)?)));
            }
        }
    }
    lines.extend(loaded().iter().map(|(name, problem)| precise(name, problem)));
    lines
}

/// Name, moments, rates, length in s: every branch of the torque-free closed form, and long ways along two of them.
const FREE: [(&str, [f64; 3], [f64; 3], f64); 13] = [
    ("at rest", [1.0, 2.0, 2.6], [0.0; 3], 20.0),
    ("spherical", [2.0, 2.0, 2.0], [0.7, -0.4, 1.1], 20.0),
    ("principal axis", [1.0, 2.0, 2.6], [0.0, 0.0, -3.0], 20.0),
    ("oblate", [1.0, 1.0, 1.5], [0.7, -0.4, 1.1], 20.0),
    ("prolate", [1.5, 0.8, 1.5], [0.7, -0.4, 1.1], 1e6),
    ("about the high axis", [1.0, 2.0, 2.6], [0.7, -0.4, 1.1], 20.0),
    ("about the low axis", [1.0, 2.0, 2.6], [1.1, -0.4, 0.1], 1e9),
    ("nearly symmetric", [1.0, 1.000_000_001, 1.6], [0.7, -0.4, 1.1], 20.0),
    ("flips", [1.0, 2.0, 3.0], [1e-3, 5.0, 1e-3], 60.0),
    ("rare flips", [1.0, 2.0, 3.0], [1e-12, 5.0, -1e-12], 1e4),
    ("separatrix", [1.0, 2.0, 3.0], [1.0, 0.5, 1.0], 20.0),
    ("needle", [1e-6, 1.0, 1.000_000_5], [40.0, 0.3, -0.2], 20.0),
    ("axes out of order", [2.6, 1.0, 2.0], [-0.7, 1.4, 1.1], 20.0),
];

/// A level start: the axis across the force.
const LEVEL: [f64; 4] = [0.5; 4];

/// Every branch of the Lagrange top.
fn tops() -> Vec<(&'static str, Problem)> {
    let top = |attitude: [f64; 4], rates: [f64; 3]| {
        let weight = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -4.0), arm: Vector3::z() };
        let mut problem = problem([2.0, 2.0, 1.0], rates, &[weight]);
        problem.initial.attitude = Attitude::new(attitude).expect("a unit quaternion");
        problem
    };
    let upright = [1.0, 0.0, 0.0, 0.0];
    let tilted = [0.8, 0.6, 0.0, 0.0];
    let mut oblique = top(LEVEL, [0.5, -1.0, 3.0]);
    oblique.loads[0].torque =
        Torque::ForceWorld { force: Vector3::new(1.0, 2.0, -4.0), arm: Vector3::new(0.0, 0.0, -0.7) };
    vec![
        ("sleeping", top(upright, [0.0, 0.0, 9.0])),
        ("steady precession", top(LEVEL, [0.0, 0.5, 8.0])),
        ("wavy", top(tilted, [0.3, 0.2, 9.0])),
        ("slow", top(tilted, [0.3, 1.9, 0.5])),
        ("nearly up for ever", top(LEVEL, [2.0 + 1e-12, 0.0, 0.0])),
        ("up for ever", top(LEVEL, [2.0, 0.0, 0.0])),
        ("falling", top(upright, [1e-9, 0.0, 3.0])),
        ("oblique force", oblique),
    ]
}

/// Torques along a spin, and across the symmetry axis where rates alone are known.
fn axial() -> Vec<(String, Problem)> {
    let mut problems = Vec::new();
    for axis in 0..3 {
        let (mut moment, mut rates) = (Vector3::zeros(), [0.0; 3]);
        (moment[axis], rates[axis]) = (-0.4, 1.5);
        let problem = problem(MOMENTS, rates, &[Torque::ConstantBody { moment }]);
        problems.push((format!("axis {}", axis + 1), problem));
    }
    let torque = Torque::ConstantBody { moment: Vector3::new(0.0, 0.0, 0.3) };
    let mut chirp = problem([2.0, 2.0, 3.0], [0.3, 0.0, 1.0], &[torque]);
    chirp.wants_attitude = false;
    problems.push(("chirp".to_owned(), chirp));
    problems
}

/// Nothing, each load by itself, and all of them in windows that overlap, with translation under gravity.
fn loaded() -> Vec<(String, Problem)> {
    let mut problems = vec![("nothing".to_owned(), problem(MOMENTS, RATES, &[]))];
    for (name, torque) in every_torque() {
        problems.push((name.to_owned(), problem(MOMENTS, RATES, &[torque])));
    }
    let mut all = problem(MOMENTS, RATES, &[]);
    let edges = [(0.3, 1.1), (0.0, 0.7), (0.65, 1.85), (0.1, 0.9), (0.5, 1.3), (0.2, 1.7), (0.4, 1.4)];
    all.loads = every_torque()
        .into_iter()
        .zip(edges)
        .map(|((_, torque), (start, end))| Load { torque, window: Window { start, end } })
        .collect();
    all.gravity = Vector3::new(0.0, 0.0, -9.81);
    all.wants_translation = true;
    problems.push(("everything, in windows".to_owned(), all));
    problems
}

/// Of the states, and of every channel that can be had of them, in axes turned from the principal ones.
fn hash(name: &str, problem: &Problem, times: &[f64], fresh: &dyn Fn(&Problem) -> Fresh, batch: usize) -> Hash {
    let mut propagator = fresh(problem).unwrap_or_else(|error| panic!("{name}: {error}"));
    let channels = channels(problem);
    let (mut states, mut samples) = (States::default(), BodySamples::new(&channels));
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 0.2, 0.1));
    let derivation = Derivation::new(problem, turn);
    // By columns and then times, so that batches do not matter.
    let mut columns: Vec<Hash> = Vec::new();
    for times in times.chunks(batch) {
        propagator.fill(times, &mut states).unwrap_or_else(|error| panic!("{name}: {error}"));
        derivation.derive(times, &states, &mut samples);
        let States { attitude, angular_velocity, position, velocity, .. } = &states;
        let all = attitude.iter().chain(angular_velocity).chain(position).chain(velocity).chain(samples.columns());
        for (index, column) in all.enumerate() {
            columns.resize(columns.len().max(index + 1), Hash::EMPTY);
            for value in column {
                columns[index].add(*value);
            }
        }
    }
    columns.into_iter().fold(Hash::EMPTY, Hash::joined)
}

/// Every channel where the attitude is there, those of the rates where it is not.
fn channels(problem: &Problem) -> Vec<Channel> {
    let translational = |channel: &Channel| matches!(channel, Channel::Position | Channel::Velocity);
    if !problem.wants_attitude {
        return vec![Channel::AngularVelocity, Channel::AngularMomentumBody, Channel::RotationalEnergy];
    }
    // Derived channels are hashed of scenes.
    let is_told =
        |channel: &Channel| *channel < Channel::EulerZxz && (problem.wants_translation || !translational(channel));
    Channel::ALL.into_iter().filter(is_told).collect()
}

/// By the integrator in double-double, both halves of each number, over two seconds.
fn precise(name: &str, problem: &Problem) -> String {
    let mut taylor = PreciseTaylor::new(problem).unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut hash = Hash::EMPTY;
    for time in grid(2.0, 8) {
        let state = taylor.at(time).expect("a finite motion").expect("no limit of steps");
        for value in state.attitude.iter().chain(&state.angular_velocity).chain(&state.position) {
            hash.add(value.hi());
            hash.add(value.lo());
        }
    }
    hash.line(&format!("precise Taylor, {name}"))
}
