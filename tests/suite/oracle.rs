//! The torque-free closed form against thirty-digit trajectories: absolute limits, the same for every case and time.

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
        if attitude > ATTITUDE_LIMIT_RAD || omega > RELATIVE_LIMIT || momentum > RELATIVE_LIMIT {
            missed.push(&case.name);
        }
    }
    assert!(missed.is_empty(), "beyond the limits: {missed:?}");
}
