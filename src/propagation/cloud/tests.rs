use std::sync::Arc;

use nalgebra::Vector3;

use super::fit::fit;
use super::stepper::{Exactness, Stepper};
use crate::body::{AngularVelocity, Attitude, Particle, ParticleCloud, State};
use crate::dynamics::{General, GeneralLoad, Load, Problem, SpringCloud, Springs, Torque, Window};
use crate::numerics::{DoubleDouble, Scalar};

/// Four particles on springs so stiff that a spin of 4 rad/s stretches them by some 1e-12 of their length.
fn stiff() -> Problem {
    let at = |mass, [x, y, z]: [f64; 3]| Particle { mass, position: Vector3::new(x, y, z) };
    let particles = [
        at(0.1, [0.0, 0.1, 0.04]),
        at(0.1, [0.0, -0.1, 0.04]),
        at(0.05, [0.04, 0.0, -0.08]),
        at(0.05, [-0.04, 0.01, -0.08]),
    ];
    let cloud = ParticleCloud::new(particles.to_vec()).expect("a cloud");
    let body = cloud.mass_properties().expect("a body");
    let springs = Springs { stiffness: 1e12, damping: 1e3, is_relaxed: false };
    let kind = General::Cloud(SpringCloud::new(&cloud, &body, springs).expect("held"));
    Problem {
        moments: body.moments,
        mass: body.mass,
        initial: State {
            attitude: Attitude::identity(),
            angular_velocity: AngularVelocity::from_vector(Vector3::new(0.5, 1.0, 4.0)),
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
        },
        loads: vec![Load { torque: Torque::General(Arc::new(GeneralLoad::new(kind))), window: Window::ALWAYS }],
        gravity: Vector3::zeros(),
        wants_attitude: true,
        wants_translation: false,
    }
}

fn forces<F: Scalar>(exactness: Exactness, time: f64) -> (Vec<[f64; 3]>, f64) {
    let mut stepper = Stepper::<F>::new(&stiff(), exactness).expect("covered");
    let time = DoubleDouble::from(time);
    while stepper.end() < time {
        stepper.advance().expect("finite");
    }
    let (motion, _) = stepper.at(time).expect("in shape");
    stepper.springs.forces(&motion)
}

/// From positions in f64 these forces would be off by ε / 1e-12, a part in five thousand.
#[test]
fn forces_of_the_stiffest_springs_have_all_their_digits() {
    let time = 2e-5;
    let (found, held) = forces::<f64>(Exactness { order: 20, tolerance: 1e-16, enough: 1e-9 }, time);
    let (exact, wanted) = forces::<DoubleDouble>(Exactness { order: 36, tolerance: 1e-32, enough: 1e-17 }, time);
    let size = exact.iter().flatten().fold(0.0, |most: f64, component| most.max(component.abs()));
    assert!(size > 0.1, "{size} N");
    for (found, exact) in found.iter().flatten().zip(exact.iter().flatten()) {
        assert!((found - exact).abs() <= 1e-13 * size, "{:e} of {size} N", found - exact);
    }
    assert!((held / wanted - 1.0).abs() <= 1e-12, "{held:e} J is not {wanted:e} J");
}

#[test]
fn particles_in_one_place_have_no_attitude() {
    let exactness = Exactness { order: 20, tolerance: 1e-16, enough: 1e-9 };
    let stepper = Stepper::<f64>::new(&stiff(), exactness).expect("covered");
    let (mut motion, attitude) = stepper.at(DoubleDouble::ZERO).expect("in shape");
    assert!(fit(&stepper.springs, &motion, attitude, 1e-9).is_some());
    for position in &mut motion.positions {
        *position = [DoubleDouble::ZERO; 3];
    }
    assert_eq!(fit(&stepper.springs, &motion, attitude, 1e-9), None);
}
