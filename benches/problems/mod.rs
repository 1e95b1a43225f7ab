//! The bodies that every benchmark takes.

use nalgebra::Vector3;
use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::dynamics::{Load, Problem, Torque, Window};

/// A tri-axial body, kg m².
pub const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
/// Its rates at t = 0, rad/s.
pub const RATES: [f64; 3] = [1.0, 2.0, 1.5];

/// A body on which nothing acts, its attitude asked for.
pub fn free(moments: [f64; 3], rates: [f64; 3]) -> Problem {
    Problem {
        moments: PrincipalMoments::new(moments).expect("moments of a body"),
        mass: Some(1.0),
        initial: State {
            attitude: Attitude::identity(),
            angular_velocity: AngularVelocity::new(rates).expect("finite"),
            position: Vector3::zeros(),
            velocity: Vector3::new(1.0, 0.0, 0.0),
        },
        loads: Vec::new(),
        gravity: Vector3::zeros(),
        wants_attitude: true,
        wants_translation: false,
    }
}

/// The tri-axial body under a moment that stays in the body.
pub fn pushed() -> Problem {
    let mut problem = free(MOMENTS, RATES);
    let torque = Torque::ConstantBody { moment: Vector3::new(0.1, 0.2, -0.1) };
    problem.loads.push(Load { torque, window: Window::ALWAYS });
    problem
}

/// Sample times 10 ms apart.
pub fn times(count: u32) -> Vec<f64> {
    (0..count).map(|index| f64::from(index) * 0.01).collect()
}
