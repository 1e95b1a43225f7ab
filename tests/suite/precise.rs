//! The double-double Taylor integrator against the reference trajectories, far below f64.

use nalgebra::{Quaternion, UnitQuaternion};
use polhode::body::Attitude;
use polhode::dynamics::{Problem, Torque};
use polhode::numerics::DoubleDouble;
use polhode::propagation::{BrakedRotation, PreciseState, PreciseTaylor};

use crate::forced_oracle::{forced_cases, problem};
use crate::motions::{MOMENTS, RATES};
use crate::reference::{Case, Sample, cases};

/// Its worst error on the forced cases: rad, or relative to the largest ω, or m.
const FORCED_LIMIT: f64 = 3e-30;
/// Its worst error on torque-free cases of few turns, away from the separatrix; dzhanibekov_1e-2 stretches errors most.
const FREE_LIMIT: f64 = 1e-27;
/// Those cases. On the separatrix itself, 106 bits are lost as fast as 53: only the closed form stays there.
const FREE: [&str; 8] = [
    "asymmetric_free",
    "asymmetric_high",
    "asymmetric_low",
    "dzhanibekov_1e-2",
    "flat_plate_free",
    "nome_switch_above",
    "spherical_free",
    "symmetric_oblate_free",
];

/// A case is started from its own quaternion, normalised by the integrator.
fn exact_problem(case: &Case) -> Problem {
    let mut problem = problem(case);
    let [w, x, y, z] = case.q0;
    let quaternion = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    problem.initial.attitude = Attitude::from_world_from_body(quaternion);
    problem
}

fn size<const N: usize>(vector: [DoubleDouble; N]) -> f64 {
    vector.iter().map(|component| component.hi() * component.hi()).sum::<f64>().sqrt()
}

fn distance<const N: usize>(a: [DoubleDouble; N], b: [DoubleDouble; N]) -> f64 {
    size(std::array::from_fn::<_, N, _>(|i| a[i] - b[i]))
}

/// Attitude in rad, ω relative, x in m.
fn errors(sample: &Sample, state: &PreciseState) -> [f64; 3] {
    let negated = sample.q.map(|component| -component);
    let apart = distance(sample.q, state.attitude).min(distance(negated, state.attitude));
    let rates = distance(sample.omega, state.angular_velocity) / size(sample.omega).max(1e-300);
    [2.0 * apart, rates, sample.x.map_or(0.0, |x| distance(x, state.position))]
}

fn worst(case: &Case) -> [f64; 3] {
    let mut taylor = PreciseTaylor::new(&exact_problem(case)).expect("covered");
    let mut worst = [0.0_f64; 3];
    for sample in &case.samples {
        let state = taylor.at(sample.t).expect("a finite motion").expect("no limit of steps");
        for (worst, error) in worst.iter_mut().zip(errors(sample, &state)) {
            *worst = worst.max(error);
        }
    }
    println!("{:28} attitude, omega, x: {worst:?}; {} steps", case.name, taylor.effort().steps);
    worst
}

#[test]
fn every_forced_case_is_right_to_29_digits() {
    for case in forced_cases() {
        let worst = worst(&case);
        assert!(worst.iter().all(|error| *error < FORCED_LIMIT), "{}: {worst:?}", case.name);
    }
}

#[test]
fn torque_free_cases_are_right_to_27_digits() {
    let mut cases = cases();
    cases.retain(|case| FREE.contains(&case.name.as_str()));
    assert_eq!(cases.len(), FREE.len());
    for case in cases {
        let worst = worst(&case);
        assert!(worst.iter().all(|error| *error < FREE_LIMIT), "{}: {worst:?}", case.name);
    }
}

#[test]
fn a_limit_of_steps_is_kept() {
    let case = &forced_cases()[0];
    let mut taylor = PreciseTaylor::new(&exact_problem(case)).expect("covered").limited_to(3);
    assert_eq!(taylor.at(case.t_end).expect("a finite motion"), None);
    assert_eq!(taylor.effort().steps, 3);
    assert!(taylor.reached() > 0.0 && taylor.reached() < case.t_end);
    let within = 0.5 * taylor.reached();
    assert!(taylor.at(taylor.reached()).expect("it ascends").is_some(), "what was reached is at hand");
    assert!(taylor.at(within).is_err(), "times ascend");
}

/// e⁻⁹⁰⁰ is no f64: what is left of L by then is below the smallest number, and the body rests.
#[test]
fn what_a_brake_has_taken_all_of_rests() {
    let rate = 4.0;
    let braked = crate::motions::problem(MOMENTS, RATES, &[Torque::MomentumBrake { rate }]);
    let mut exact = PreciseTaylor::new(&braked).expect("covered");
    for turned_down in [100.0, 500.0, 700.0, 744.0, 900.0, 1e4, 1e9] {
        let time = turned_down / rate;
        let state = exact.at(time).expect("a finite motion").expect("no limit of steps");
        let left = size(state.angular_velocity);
        let most = 3.0 * libm::exp(-turned_down) * size(RATES.map(DoubleDouble::from));
        assert!(left <= most.max(1e-240), "|ω| is {left:e} after e^-{turned_down}");
        let found = crate::motions::run(BrakedRotation::new(&braked).expect("covered"), &[time]);
        let attitude = crate::motions::row(&found.attitude, 0).map(DoubleDouble::from);
        let apart = distance(attitude, state.attitude).min(distance(attitude.map(|part| -part), state.attitude));
        assert!(apart < 1e-15, "{apart:e} after e^-{turned_down}");
    }
    let rest = exact.at(1e10).expect("a finite motion").expect("no limit of steps");
    assert_eq!(size(rest.angular_velocity), 0.0);
}
