//! Closed forms under a brake along L and under a torque along the spin: published values, references, agreement with Taylor.

use nalgebra::Vector3;
use polhode::body::Attitude;
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::propagation::{AxialTorque, BrakedRotation, FreeRotation, Taylor};

use crate::forced_oracle;
use crate::motions::{MOMENTS, RATES, grid, problem, row, run};
use crate::reference::cases;

fn braked(moments: [f64; 3], rates: [f64; 3], rate: f64) -> Problem {
    problem(moments, rates, &[Torque::MomentumBrake { rate }])
}

/// Largest difference of any component of attitude or ω.
fn largest_difference(left: &polhode::propagation::States, right: &polhode::propagation::States) -> f64 {
    let pairs =
        left.attitude.iter().zip(&right.attitude).chain(left.angular_velocity.iter().zip(&right.angular_velocity));
    pairs.flat_map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).abs())).fold(0.0, f64::max)
}

#[test]
fn a_brake_along_momentum_gives_the_rates_of_an_integration_in_25_digits() {
    let states = run(BrakedRotation::new(&braked([3.0, 5.0, 7.0], [0.1, 0.4, 0.05], 0.02)).expect("covered"), &[60.0]);
    let expected = [0.030_527_111_006_475_92, -0.120_354_487_070_889_5, -0.015_407_507_924_419_987];
    for (found, expected) in row(&states.angular_velocity, 0).into_iter().zip(expected) {
        assert!((found - expected).abs() < 2e-16, "{found} {expected}");
    }
}

#[test]
fn a_brake_keeps_the_direction_of_momentum() {
    let problem = braked(MOMENTS, RATES, 0.05);
    let times = grid(400.0, 100);
    let states = run(BrakedRotation::new(&problem).expect("covered"), &times);
    let momentum = |i: usize| {
        let q = polhode::body::Attitude::new(row(&states.attitude, i)).expect("unit");
        let omega = Vector3::from(row(&states.angular_velocity, i));
        q.to_world(&omega.component_mul(&problem.moments.vector()))
    };
    let start = momentum(0);
    for (i, time) in times.iter().enumerate() {
        let left = libm::exp(-0.05 * time);
        assert!((momentum(i) - left * start).norm() < 4e-15 * left * start.norm(), "{time} s");
    }
}

#[test]
fn brakes_agree_with_taylor() {
    for rate in [0.0, 1e-12, 0.03, 0.7] {
        let problem = braked(MOMENTS, RATES, rate);
        let times = grid(20.0, 40);
        let closed = run(BrakedRotation::new(&problem).expect("covered"), &times);
        let stepped = run(Taylor::new(&problem, 1e-16).expect("covered"), &times);
        let difference = largest_difference(&closed, &stepped);
        assert!(difference < 2e-14, "{rate}: {difference:e}");
    }
}

#[test]
fn a_brake_that_is_not_there_leaves_the_free_motion() {
    let problem = braked(MOMENTS, RATES, 0.0);
    let free = Problem { loads: Vec::new(), ..problem.clone() };
    let times = grid(1e6, 10);
    let closed = run(BrakedRotation::new(&problem).expect("covered"), &times);
    assert_eq!(closed, run(FreeRotation::new(&free).expect("covered"), &times));
}

#[test]
fn a_long_brake_ends_where_the_free_motion_is_at_its_whole_time() {
    // (1 − e^(−ct))/c tends to 1/c = 2²⁰ s, at which the torque-free motion is known.
    let problem = braked(MOMENTS, RATES, libm::exp2(-20.0));
    let free = Problem { loads: Vec::new(), ..problem.clone() };
    let closed = run(BrakedRotation::new(&problem).expect("covered"), &[1e9]);
    let whole = run(FreeRotation::new(&free).expect("covered"), &[libm::exp2(20.0)]);
    for k in 0..4 {
        assert!((closed.attitude[k][0] - whole.attitude[k][0]).abs() < 1e-15);
    }
}

#[test]
fn a_torque_along_the_spin_is_right_to_rounding() {
    let case = cases().into_iter().find(|case| case.name == "torque_body_principal").expect("a case");
    let motion = AxialTorque::new(&forced_oracle::problem(&case)).expect("covered");
    let times: Vec<f64> = case.samples.iter().map(|sample| sample.t).collect();
    let states = run(motion, &times);
    for (i, sample) in case.samples.iter().enumerate() {
        let attitude = sample.attitude_error(row(&states.attitude, i));
        assert!(attitude < 1e-15, "{attitude:e} rad at {} s", sample.t);
        assert!(sample.omega_error(row(&states.angular_velocity, i)) < 3e-16, "{} s", sample.t);
    }
}

#[test]
fn rates_across_a_torque_along_the_axis_give_the_published_chirp() {
    let torque = Torque::ConstantBody { moment: Vector3::new(0.0, 0.0, 0.3) };
    let mut problem = problem([2.0, 2.0, 3.0], [0.3, 0.0, 1.0], &[torque]);
    assert!(!AxialTorque::covers(&problem), "its attitude has no elementary form");
    problem.wants_attitude = false;
    let states = run(AxialTorque::new(&problem).expect("covered"), &[20.0]);
    let expected = [0.122_424_618_5, 0.273_883_575_2, 3.0];
    for (found, expected) in row(&states.angular_velocity, 0).into_iter().zip(expected) {
        assert!((found - expected).abs() < 6e-11, "{found} {expected}");
    }
}

#[test]
fn torques_along_every_axis_agree_with_taylor() {
    for axis in 0..3 {
        let (mut moment, mut rates) = (Vector3::zeros(), [0.0; 3]);
        (moment[axis], rates[axis]) = (-0.4, 1.5);
        let problem = problem(MOMENTS, rates, &[Torque::ConstantBody { moment }]);
        let times = grid(10.0, 40);
        let closed = run(AxialTorque::new(&problem).expect("covered"), &times);
        let difference = largest_difference(&closed, &run(Taylor::new(&problem, 1e-16).expect("covered"), &times));
        assert!(difference < 1e-14, "axis {axis}: {difference:e}");
    }
}

#[test]
fn torques_in_the_world_along_the_spin_agree_with_taylor() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    // Turned about the axis, upside down, and with the body's x along the world's z.
    let attitudes = [([0.6, 0.0, 0.0, 0.8], 2), ([0.0, 1.0, 0.0, 0.0], 2), ([half, 0.0, -half, 0.0], 0)];
    for (attitude, axis) in attitudes {
        let mut rates = [0.0; 3];
        rates[axis] = 1.5;
        let mut problem = problem(MOMENTS, rates, &[Torque::ConstantWorld { moment: Vector3::new(0.0, 0.0, -0.4) }]);
        problem.initial.attitude = Attitude::new(attitude).expect("a unit quaternion");
        let times = grid(10.0, 40);
        let closed = run(AxialTorque::new(&problem).expect("covered"), &times);
        let difference = largest_difference(&closed, &run(Taylor::new(&problem, 1e-16).expect("covered"), &times));
        assert!(difference < 1e-14, "{attitude:?}: {difference:e}");
        // Off the axis by a rounding, the spin does not stay on it.
        problem.initial.attitude = Attitude::new([0.6, 1e-17, 0.0, 0.8]).expect("a unit quaternion");
        assert!(!AxialTorque::covers(&problem));
    }
}

#[test]
fn windows_are_left_to_steppers() {
    let window = Window { start: 1.0, end: 2.0 };
    for torque in [Torque::MomentumBrake { rate: 0.1 }, Torque::ConstantBody { moment: Vector3::z() }] {
        let mut problem = problem(MOMENTS, [0.0, 0.0, 1.0], std::slice::from_ref(&torque));
        problem.loads = vec![Load { torque, window }];
        assert!(!BrakedRotation::covers(&problem) && !AxialTorque::covers(&problem));
        assert!(BrakedRotation::new(&problem).is_err() && AxialTorque::new(&problem).is_err());
    }
}
