//! The steppers against thirty-digit trajectories under torque, in units of each case's own rounding floor.

use nalgebra::Vector3;
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::numerics::DoubleDouble;
use polhode::propagation::{Dop853, FixedStep, FixedStepMethod, States, Taylor};
use serde_json::Value;

use crate::motions::{row, run};
use crate::reference::{Case, cases};

/// The tightest tolerance, at which rounding is all that is left.
const TIGHTEST: f64 = 1e-16;
/// Taylor's worst error, in floors.
const TAYLOR_FLOORS: f64 = 1.0;
/// DOP853's worst error at a tolerance of 1e-13: rad, or relative.
const DOP853_LIMIT: f64 = 1e-10;
/// The same of the splitting of order 8.
const SPLITTING8_LIMIT: f64 = 3e-11;

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from([0, 1, 2].map(|i| value[i].as_f64().expect("a number")))
}

fn load(component: &Value) -> Load {
    let number = |key: &str| component[key].as_f64();
    let torque = match component["kind"].as_str().expect("a kind") {
        "constant_body" => Torque::ConstantBody { moment: vector(&component["torque"]) },
        "constant_world" => Torque::ConstantWorld { moment: vector(&component["torque"]) },
        "linear_damping" => Torque::LinearDamping { coefficient: number("c").expect("c") },
        "heavy_top" => Torque::ForceWorld {
            force: vector(&component["gravity_world"]) * number("mass").expect("mass"),
            arm: vector(&component["r_cm_body"]),
        },
        "gravity_gradient" => Torque::GravityGradient { mean_motion: number("n").expect("n") },
        "point_force_world" => {
            Torque::ForceWorld { force: vector(&component["force"]), arm: vector(&component["point_body"]) }
        }
        "point_force_body" => {
            Torque::ForceBody { force: vector(&component["force"]), arm: vector(&component["point_body"]) }
        }
        other => panic!("unknown torque {other}"),
    };
    let window =
        Window { start: number("t_start").unwrap_or(f64::NEG_INFINITY), end: number("t_end").unwrap_or(f64::INFINITY) };
    Load { torque, window }
}

/// The case's problem with all that acts, and translation where the case has one.
pub fn problem(case: &Case) -> Problem {
    Problem {
        loads: case.torques.as_array().expect("a list").iter().map(load).collect(),
        wants_translation: case.samples[0].x.is_some(),
        ..case.free_problem()
    }
}

/// The worst errors over the samples: attitude in rad, then ω, L and x relative to their largest values.
fn errors(case: &Case, states: &States) -> [f64; 4] {
    let mut worst = [0.0_f64; 4];
    let mut largest = [1.0, 0.0, 0.0, 0.0_f64];
    for (i, sample) in case.samples.iter().enumerate() {
        let (q, omega) = (row(&states.attitude, i), row(&states.angular_velocity, i));
        // The position is judged where there is one.
        let (position, position_error) = sample.x.map_or((0.0, 0.0), |x| {
            let found = row(&states.position, i);
            let difference = Vector3::from([0, 1, 2].map(|k| (x[k] - DoubleDouble::from(found[k])).hi()));
            (size(x), difference.norm())
        });
        let sizes = [1.0, size(sample.omega), size(sample.l_world), position];
        let found = [
            sample.attitude_error(q),
            sample.omega_error(omega) * sizes[1],
            sample.momentum_error(case.moments, q, omega) * sizes[2],
            position_error,
        ];
        assert!(found.iter().all(|error| error.is_finite()), "{}: {found:?} at {} s", case.name, sample.t);
        for k in 0..4 {
            worst[k] = worst[k].max(found[k]);
            largest[k] = largest[k].max(sizes[k]);
        }
    }
    std::array::from_fn(|k| if worst[k] > 0.0 { worst[k] / largest[k] } else { 0.0 })
}

fn size(vector: [DoubleDouble; 3]) -> f64 {
    Vector3::from(vector.map(DoubleDouble::hi)).norm()
}

pub fn forced_cases() -> Vec<Case> {
    let mut cases = cases();
    cases.retain(|case| case.torques.as_array().is_some_and(|torques| !torques.is_empty()));
    cases
}

fn times(case: &Case) -> Vec<f64> {
    case.samples.iter().map(|sample| sample.t).collect()
}

#[test]
fn taylor_is_right_to_rounding_on_every_forced_case() {
    let mut missed = Vec::new();
    for case in forced_cases() {
        let taylor = Taylor::new(&problem(&case), TIGHTEST).expect("covered");
        let floors = errors(&case, &run(taylor, &times(&case))).map(|error| error / case.floor_steps_rad);
        println!("{:28} attitude, omega, L, x in floors: {floors:.3?}", case.name);
        if floors.iter().any(|floors| *floors > TAYLOR_FLOORS) {
            missed.push(case.name);
        }
    }
    assert!(missed.is_empty(), "beyond the limit: {missed:?}");
}

#[test]
fn dop853_is_near_every_forced_case() {
    for case in forced_cases() {
        let dop853 = Dop853::new(&problem(&case), 1e-13).expect("covered");
        let errors = errors(&case, &run(dop853, &times(&case)));
        println!("{:28} attitude, omega, L, x: {errors:?}", case.name);
        assert!(errors.iter().all(|error| *error < DOP853_LIMIT), "{}: {errors:?}", case.name);
    }
}

/// Of the methods with a fixed step, one of high order against digits from elsewhere: twenty steps a radian, or a second.
#[test]
fn splitting8_is_near_every_forced_case() {
    for case in forced_cases() {
        let rate = case.free_problem().initial.angular_velocity.in_body().norm();
        let step = 0.05 / rate.max(1.0);
        let splitting8 = FixedStep::new(&problem(&case), FixedStepMethod::Splitting8, step).expect("covered");
        let errors = errors(&case, &run(splitting8, &times(&case)));
        println!("{:28} attitude, omega, L, x: {errors:?}", case.name);
        assert!(errors.iter().all(|error| *error < SPLITTING8_LIMIT), "{}: {errors:?}", case.name);
    }
}
