//! What the steps of a motion under torques owe: rest, any size, what cannot be, what cannot go on.

use nalgebra::Vector3;
use polhode::body::Attitude;
use polhode::dynamics::{Problem, Torque};
use polhode::propagation::{Effort, PropagationError, Propagator, States, Taylor};

use crate::motions::{MOMENTS, RATES, every_torque, grid, problem, row, run, state};

const TIGHTEST: f64 = 1e-16;

fn taylor(problem: &Problem) -> Taylor {
    Taylor::new(problem, TIGHTEST).expect("covered")
}

#[test]
fn rest_costs_one_step() {
    let problem = problem(MOMENTS, [0.0; 3], &[]);
    let mut propagator = taylor(&problem);
    let mut states = States::default();
    propagator.fill(&[0.0, 1e9, 1e15], &mut states).expect("a finite motion");
    let Effort { evaluations, steps, rejections, .. } = propagator.effort();
    assert_eq!((evaluations, steps, rejections), (1, 1, 0));
    for i in 0..3 {
        assert_eq!(state(&states, i).attitude, problem.initial.attitude);
    }
}

/// The same motion, faster or slower by powers of two and on bodies of any size, in as many steps.
#[test]
fn rates_and_moments_of_any_size() {
    for power in [-36, -20, 20, 36] {
        let scale = libm::exp2(f64::from(power));
        let reference = problem(MOMENTS, RATES, &[Torque::ConstantBody { moment: Vector3::new(0.3, -0.2, 0.1) }]);
        let faster = problem(
            MOMENTS.map(|moment| moment * scale),
            RATES.map(|rate| rate * scale),
            &[Torque::ConstantBody { moment: Vector3::new(0.3, -0.2, 0.1) * scale * scale * scale }],
        );
        let times = grid(20.0, 10);
        let faster_times: Vec<f64> = times.iter().map(|time| time / scale).collect();
        let (mut one, mut other) = (taylor(&reference), taylor(&faster));
        let (mut slow, mut fast) = (States::default(), States::default());
        one.fill(&times, &mut slow).expect("a finite motion");
        other.fill(&faster_times, &mut fast).expect("a finite motion");
        let shortest_step_s = other.effort().shortest_step_s.map(|step| step * scale);
        assert_eq!(one.effort(), Effort { shortest_step_s, ..other.effort() });
        assert_eq!(slow.attitude, fast.attitude);
    }
}

#[test]
fn what_starts_from_rest_gets_going() {
    for (name, torque) in every_torque() {
        let states = run(taylor(&problem(MOMENTS, [0.0; 3], &[torque])), &[0.0, 5.0]);
        let moves = Vector3::from(row(&states.angular_velocity, 1)).norm() > 1e-3;
        assert_eq!(moves, !["linear damping", "momentum brake"].contains(&name), "{name}");
    }
}

#[test]
fn next_to_rest_is_no_special_case() {
    // Whose square, or whose turn's square in seconds, is no f64: the spin stays, and turns nothing.
    for rate in [1e-100, 1e-170, 1e-300] {
        let problem = problem(MOMENTS, [rate, 0.0, 0.0], &[Torque::ConstantBody { moment: Vector3::zeros() }]);
        let states = run(taylor(&problem), &[1.0, 1e9]);
        assert_eq!(states.angular_velocity[0], [rate; 2]);
        for i in 0..2 {
            assert_eq!(state(&states, i).attitude, problem.initial.attitude);
        }
    }
}

#[test]
fn rates_alone_need_no_attitude() {
    let torques = [every_torque()[0].1.clone(), every_torque()[2].1.clone()];
    let mut problem = problem(MOMENTS, RATES, &torques);
    let times = grid(10.0, 20);
    let with = run(taylor(&problem), &times);
    problem.wants_attitude = false;
    let without = run(taylor(&problem), &times);
    assert!(without.attitude[0].is_empty());
    for i in 0..times.len() {
        let found = Vector3::from(row(&without.angular_velocity, i));
        assert!((found - Vector3::from(row(&with.angular_velocity, i))).norm() < 1e-14);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let force = Torque::ForceWorld { force: Vector3::x(), arm: Vector3::zeros() };
    let mut massless = problem(MOMENTS, RATES, &[force]);
    massless.mass = None;
    assert!(Taylor::new(&massless, TIGHTEST).is_ok());
    massless.wants_translation = true;
    let orbits = [0.1, 0.2].map(|mean_motion| Torque::GravityGradient { mean_motion });
    let refused = |problem: &Problem, tolerance: f64| {
        matches!(Taylor::new(problem, tolerance), Err(PropagationError::NotCovered { method: "Taylor", .. }))
    };
    assert!(refused(&massless, TIGHTEST));
    assert!(refused(&problem(MOMENTS, RATES, &orbits), TIGHTEST));
    for tolerance in [0.0, 1.0, -1e-9, f64::NAN, f64::INFINITY] {
        assert!(refused(&problem(MOMENTS, RATES, &[]), tolerance), "{tolerance}");
    }
    let mut propagator = taylor(&problem(MOMENTS, RATES, &[]));
    let mut states = States::default();
    for times in [[1.0, 0.5], [f64::NAN, 1.0], [1.0, f64::INFINITY], [-1.0, 0.0]] {
        let found = propagator.fill(&times, &mut states);
        assert!(matches!(found, Err(PropagationError::NotAscending { .. })), "{times:?}: {found:?}");
    }
}

#[test]
fn a_motion_that_cannot_go_on_ends_with_its_time() {
    let pushed = |moments: [f64; 3], moment: f64| {
        let push = Torque::ConstantBody { moment: Vector3::repeat(moment) };
        let mut problem = problem(moments, [1e-9, 0.0, 0.0], &[push]);
        problem.loads[0].window.start = 3.0;
        taylor(&problem).fill(&[1.0, 4.0], &mut States::default())
    };
    // An acceleration that is no number.
    assert_eq!(pushed([1e-3; 3], 1e307), Err(PropagationError::NotFinite { time: 3.0 }));
    // Turns shorter than the time can tell apart.
    let found = pushed(MOMENTS, 1e300);
    assert!(matches!(found, Err(PropagationError::StepTooSmall { time: 3.0, .. })), "{found:?}");
}

#[test]
fn turned_worlds_give_turned_motions() {
    // Isotropy: turn the first attitude and every world vector, and the motion turns with them.
    let turn = Attitude::new([0.6, 0.0, 0.8, 0.0]).expect("a unit quaternion");
    let moment = Vector3::new(-0.1, 0.25, 0.2);
    let here = problem(MOMENTS, RATES, &[Torque::ConstantWorld { moment }]);
    let mut there = problem(MOMENTS, RATES, &[Torque::ConstantWorld { moment: turn.to_world(&moment) }]);
    let turned = turn.world_from_body() * here.initial.attitude.world_from_body();
    there.initial.attitude = Attitude::from_world_from_body(turned);
    let times = grid(10.0, 20);
    let (here, there) = (run(taylor(&here), &times), run(taylor(&there), &times));
    for i in 0..times.len() {
        let expected = turn.world_from_body() * state(&here, i).attitude.world_from_body();
        assert!(state(&there, i).attitude.angle_to(Attitude::from_world_from_body(expected)) < 1e-13);
    }
}
