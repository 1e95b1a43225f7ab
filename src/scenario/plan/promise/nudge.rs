use std::sync::Arc;

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::body::{AngularVelocity, Attitude};
use crate::dynamics::{Problem, Torque};

/// The same problem with every number of its start and of its loads off by about one rounding, up or down by the bits
/// of `pattern`. Zeros stay: symmetries of the motion that f64 keeps are kept.
pub fn nudged(problem: &Problem, mut pattern: u64) -> Problem {
    let mut nudge = move |value: f64| {
        // Other bits come up as the pattern is turned round.
        pattern = pattern.rotate_left(1);
        if pattern & 1 == 1 { value * (1.0 + f64::EPSILON) } else { value * (1.0 - f64::EPSILON) }
    };
    let mut problem = problem.clone();
    let attitude = problem.initial.attitude.wxyz().map(&mut nudge);
    let attitude = UnitQuaternion::new_normalize(Quaternion::from(attitude_in_order(attitude)));
    problem.initial.attitude = Attitude::from_world_from_body(attitude);
    let rates = problem.initial.angular_velocity.in_body().map(&mut nudge);
    problem.initial.angular_velocity = AngularVelocity::from_vector(rates);
    for load in &mut problem.loads {
        if let Some(profile) = load.torque.profile_mut() {
            *profile = Arc::new(profile.transformed(&Matrix3::from_diagonal(&Vector3::repeat(1.0).map(&mut nudge))));
        }
        let mut vector = |v: &mut Vector3<f64>| *v = v.map(&mut nudge);
        match &mut load.torque {
            Torque::ConstantBody { moment } | Torque::ConstantWorld { moment } => vector(moment),
            Torque::ForceBody { force, .. } | Torque::ForceWorld { force, .. } => vector(force),
            Torque::MagneticDipole { field, .. } => vector(field),
            // Done already; the numbers of general loads stand as they are, and the start is off all the same.
            Torque::ProfileBody { .. }
            | Torque::ProfileWorld { .. }
            | Torque::ForceProfileBody { .. }
            | Torque::ForceProfileWorld { .. }
            | Torque::Rotor { .. }
            | Torque::General(_) => {}
            Torque::MomentumBrake { rate } => *rate = nudge(*rate),
            Torque::LinearDamping { coefficient } => *coefficient = nudge(*coefficient),
            Torque::GravityGradient { mean_motion } => *mean_motion = nudge(*mean_motion),
        }
    }
    problem
}

/// x, y, z, w, as nalgebra keeps them.
fn attitude_in_order([w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [x, y, z, w]
}
