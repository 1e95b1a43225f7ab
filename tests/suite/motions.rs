//! Problems and runs that several tests share.

use std::sync::Arc;

use nalgebra::Vector3;
use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::dynamics::{Interpolation, Load, Problem, Profile, Torque, Window};
use polhode::propagation::{Propagator, States};

/// The body of most tests, kg m².
pub const MOMENTS: [f64; 3] = [1.0, 2.0, 2.6];
/// Its rates at t = 0, rad/s.
pub const RATES: [f64; 3] = [0.7, -0.4, 1.1];
/// An attitude along no axis.
pub const TILTED: [f64; 4] = [0.5, 0.5, -0.5, 0.5];

/// A body under loads that act always.
pub fn problem(moments: [f64; 3], rates: [f64; 3], torques: &[Torque]) -> Problem {
    Problem {
        moments: PrincipalMoments::new(moments).expect("a body"),
        mass: Some(2.0),
        initial: State {
            attitude: Attitude::new(TILTED).expect("a unit quaternion"),
            angular_velocity: AngularVelocity::new(rates).expect("finite rates"),
            position: Vector3::new(1.0, -2.0, 0.5),
            velocity: Vector3::new(0.1, 0.2, -0.3),
        },
        loads: torques.iter().map(|torque| Load { torque: torque.clone(), window: Window::ALWAYS }).collect(),
        gravity: Vector3::zeros(),
        wants_attitude: true,
        wants_translation: false,
    }
}

/// A cubic spline, smooth until its knot at 7.5 s.
pub fn profile(size: f64) -> Arc<Profile> {
    let vector = |x, y, z| size * Vector3::new(x, y, z);
    let points = [
        (-7.5, vector(0.2, 0.3, -0.1)),
        (-0.5, vector(-0.3, 0.1, 0.4)),
        (7.5, vector(0.5, -0.2, 0.1)),
        (15.5, vector(-0.1, 0.2, 0.2)),
    ];
    let after = vector(-0.1, 0.2, 0.2);
    Arc::new(Profile::through(&points, Interpolation::Cubic, [Vector3::zeros(), after]).expect("ascending times"))
}

/// One torque of every kind, by name.
pub fn every_torque() -> Vec<(&'static str, Torque)> {
    let arm = Vector3::new(0.1, -0.2, 0.3);
    vec![
        ("constant body", Torque::ConstantBody { moment: Vector3::new(0.3, -0.2, 0.1) }),
        ("constant world", Torque::ConstantWorld { moment: Vector3::new(-0.1, 0.25, 0.2) }),
        ("linear damping", Torque::LinearDamping { coefficient: 0.2 }),
        ("momentum brake", Torque::MomentumBrake { rate: 0.2 }),
        ("force body", Torque::ForceBody { force: Vector3::new(1.0, 0.5, -0.7), arm }),
        ("force world", Torque::ForceWorld { force: Vector3::new(-0.4, 0.9, -1.6), arm }),
        ("gravity gradient", Torque::GravityGradient { mean_motion: 0.8 }),
        ("profile body", Torque::ProfileBody { moment: profile(1.0) }),
        ("profile world", Torque::ProfileWorld { moment: profile(1.0) }),
        ("force profile body", Torque::ForceProfileBody { force: profile(3.0), arm }),
        ("force profile world", Torque::ForceProfileWorld { force: profile(3.0), arm }),
        ("rotor", Torque::Rotor { momentum: profile(1.0) }),
        (
            "magnetic dipole",
            Torque::MagneticDipole { dipole: Vector3::new(0.3, -0.4, 0.2), field: Vector3::new(0.2, -0.1, -0.15) },
        ),
    ]
}

/// The states at some times.
pub fn run(mut propagator: impl Propagator, times: &[f64]) -> States {
    let mut states = States::default();
    propagator.fill(times, &mut states).expect("a finite motion");
    states
}

/// From 0 to `end` in `count` equal parts.
pub fn grid(end: f64, count: u32) -> Vec<f64> {
    (0..=count).map(|i| end * f64::from(i) / f64::from(count)).collect()
}

/// One row of a group of columns.
pub fn row<const N: usize>(columns: &[Vec<f64>; N], i: usize) -> [f64; N] {
    columns.each_ref().map(|column| column[i])
}

/// One row of the states, as far as they were asked for.
pub fn state(states: &States, i: usize) -> State {
    let vector = |columns: &[Vec<f64>; 3]| {
        if columns[0].is_empty() { Vector3::zeros() } else { Vector3::from(row(columns, i)) }
    };
    State {
        attitude: Attitude::new(row(&states.attitude, i)).expect("a unit quaternion"),
        angular_velocity: AngularVelocity::new(row(&states.angular_velocity, i)).expect("finite rates"),
        position: vector(&states.position),
        velocity: vector(&states.velocity),
    }
}

/// The worst attitude difference between two runs in rad, and the worst in the rates in rad/s.
pub fn differences(found: &States, expected: &States) -> (f64, f64) {
    let mut worst = (0.0_f64, 0.0_f64);
    for i in 0..expected.len() {
        let (found, expected) = (state(found, i), state(expected, i));
        let rates = found.angular_velocity.in_body() - expected.angular_velocity.in_body();
        worst = (worst.0.max(found.attitude.angle_to(expected.attitude)), worst.1.max(rates.norm()));
    }
    worst
}
