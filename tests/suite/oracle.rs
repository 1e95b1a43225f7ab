//! The torque-free closed form against thirty-digit trajectories: absolute limits, the same for every case and time.

use polhode::numerics::DoubleDouble;
use polhode::propagation::{FreeRotation, Propagator, States};

use crate::reference::{Case, cases};

/// rad. Every case keeps it, from rest to 1e9 s and from the sphere to the separatrix.
const ATTITUDE_LIMIT_RAD: f64 = 1e-15;
/// Of |ω| and of |L|.
const RELATIVE_LIMIT: f64 = 2e-15;

/// Largest errors over the samples: attitude in rad, ω and L relative.
fn errors(case: &Case) -> [f64; 3] {
    let mut motion = FreeRotation::new(&case.free_problem()).expect("nothing acts");
    let mut states = States::default();
    let times: Vec<f64> = case.samples.iter().map(|sample| sample.t).collect();
    motion.fill(&times, &mut states).expect("times ascend");
    let mut worst = [0.0_f64; 3];
    for (row, sample) in case.samples.iter().enumerate() {
        let q = [0, 1, 2, 3].map(|k| states.attitude[k][row]);
        let omega = [0, 1, 2].map(|k| states.angular_velocity[k][row]);
        let found =
            [sample.attitude_error(q), sample.omega_error(omega), sample.momentum_error(case.moments, q, omega)];
        assert!(found.iter().all(|error| error.is_finite()), "{}: {found:?} at {} s", case.name, sample.t);
        worst = [0, 1, 2].map(|k| worst[k].max(found[k]));
    }
    worst
}

#[test]
fn closed_form_is_right_to_rounding_on_every_torque_free_case() {
    let mut missed = Vec::new();
    let cases = cases();
    for case in cases.iter().filter(|case| case.torques.as_array().is_some_and(Vec::is_empty)) {
        let [attitude, omega, momentum] = errors(case);
        println!("{:28} {attitude:9.2e} rad {omega:9.2e} {momentum:9.2e}", case.name);
        // Where a case says what one rounding of its inputs does, that is more.
        assert!(case.floor_rad.is_nan() || attitude < case.floor_rad, "{}: floor {:e}", case.name, case.floor_rad);
        if attitude > ATTITUDE_LIMIT_RAD || omega > RELATIVE_LIMIT || momentum > RELATIVE_LIMIT {
            missed.push(&case.name);
        }
    }
    assert!(missed.is_empty(), "beyond the limits: {missed:?}");
}

#[test]
fn cases_agree_with_themselves() {
    let cases = cases();
    assert!(cases.len() >= 48, "{} cases", cases.len());
    for case in &cases {
        let first = &case.samples[0];
        let norm = case.q0.iter().fold(DoubleDouble::ZERO, |sum, &x| sum + DoubleDouble::product(x, x)).sqrt();
        for k in 0..4 {
            let difference = DoubleDouble::from(case.q0[k]) / norm - case.q0_unit[k];
            assert!(difference.hi().abs() < 1e-30, "{}: q0 and q0_unit", case.name);
        }
        assert!(first.attitude_error(case.q0_unit.map(DoubleDouble::hi)) < 4e-16 && first.t == 0.0);
        assert!(first.omega_error(case.omega0) < 1e-30 && case.samples.last().is_some_and(|s| s.t == case.t_end));
        assert!(case.floor_steps_rad.is_nan() || case.floor_steps_rad >= case.floor_rad, "{}", case.name);
        for (found, start) in [(first.x, case.x0), (first.v, case.v0)] {
            assert!(found.is_none_or(|found| found.map(DoubleDouble::hi) == start), "{}: translation", case.name);
        }
    }
}
