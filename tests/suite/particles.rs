//! The laws of a rigid body of particles, each against its definition.

use nalgebra::{Matrix3, Unit, UnitQuaternion, Vector3};
use polhode::body::particles::{
    PointForce, RigidMotion, Spring, acceleration_of_centre, angular_acceleration, angular_momentum,
    internal_resultant, spring_forces, tensor_in_world, total_force, total_moment,
};
use polhode::body::{Attitude, BodyError, Particle, ParticleCloud};

/// Step of the finite differences, s: their error is its fourth power, their rounding its inverse.
const STEP: f64 = 1e-3;
/// What differences of fourth order leave of quantities near 10, relative; about 2× what is seen.
const DIFFERENCE: f64 = 1e-11;
/// A few roundings.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Five unequal particles without symmetry, their centre of mass far from the origin.
fn cloud() -> ParticleCloud {
    let particle = |mass, [x, y, z]: [f64; 3]| Particle { mass, position: Vector3::new(10.0 + x, y - 4.0, z + 2.5) };
    ParticleCloud::new(vec![
        particle(1.0, [0.3, -0.2, 0.9]),
        particle(2.5, [-0.8, 0.4, 0.1]),
        particle(0.7, [0.5, 1.1, -0.6]),
        particle(1.9, [0.2, -0.9, -0.4]),
        particle(0.2, [-1.3, 0.6, 1.7]),
    ])
    .unwrap()
}

/// An exact motion: turning by angle 2.1 t + 0.8 t² about a fixed axis, from a tilted attitude, on a parabola.
fn motion(time: f64) -> RigidMotion {
    let axis = Unit::new_normalize(Vector3::new(0.48, -0.6, 0.64));
    let start = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 1.1, -0.7));
    let turn = UnitQuaternion::from_axis_angle(&axis, 2.1 * time + 0.8 * time * time);
    let (launch, gravity) = (Vector3::new(3.0, -1.0, 5.0), Vector3::new(0.0, 0.0, -9.81));
    RigidMotion {
        attitude: Attitude::from_world_from_body(turn * start),
        position: launch * time + gravity * (0.5 * time * time),
        velocity: launch + gravity * time,
        acceleration: gravity,
        angular_velocity: axis.into_inner() * (2.1 + 1.6 * time),
        angular_acceleration: axis.into_inner() * 1.6,
    }
}

/// d/dt by central differences of fourth order.
fn rate<T>(at: impl Fn(f64) -> T, time: f64) -> T
where
    T: std::ops::Sub<Output = T> + std::ops::Mul<f64, Output = T>,
{
    let half = |step: f64| (at(time + step) - at(time - step)) * (0.5 / step);
    half(STEP) * (4.0 / 3.0) - half(2.0 * STEP) * (1.0 / 3.0)
}

fn assert_close(found: &Vector3<f64>, wanted: &Vector3<f64>, room: f64) {
    assert!((found - wanted).norm() <= room * wanted.norm(), "{found:?} is not {wanted:?} to {room:e}");
}

#[test]
fn points_keep_their_distances_and_move_as_the_formulae_say() {
    let time = 0.7;
    let now = motion(time);
    let (p, q) = (Vector3::new(0.3, -0.2, 0.9), Vector3::new(-1.3, 0.6, 1.7));
    let apart = (now.position_of(&p) - now.position_of(&q)).norm();
    assert!((apart - (p - q).norm()).abs() <= ROUNDING * apart);
    assert_eq!(now.position_of(&Vector3::zeros()), now.position);
    assert_close(&now.velocity_of(&p), &rate(|t| motion(t).position_of(&p), time), DIFFERENCE);
    assert_close(&now.acceleration_of(&p), &rate(|t| motion(t).velocity_of(&p), time), DIFFERENCE);
}

#[test]
fn rotation_matrix_changes_at_omega_star_times_itself() {
    let matrix = |time| *motion(time).attitude.world_from_body().to_rotation_matrix().matrix();
    let difference: Matrix3<f64> = motion(0.7).rotation_rate() - rate(matrix, 0.7);
    assert!(difference.norm() <= DIFFERENCE * motion(0.7).rotation_rate().norm());
}

#[test]
fn momenta_summed_over_particles_are_those_of_the_body() {
    let (cloud, now) = (cloud(), motion(0.7));
    let body = cloud.mass_properties().unwrap();
    assert!((cloud.centre_of_mass() - body.centre_of_mass).norm() <= ROUNDING * body.centre_of_mass.norm());
    let mass = cloud.mass();
    assert_close(&cloud.momentum(&now, &body.centre_of_mass), &(now.velocity * mass), 4.0 * ROUNDING);
    let tensor = tensor_in_world(now.attitude, &body.tensor());
    let summed = cloud.angular_momentum(&now, &body.centre_of_mass);
    assert_close(&summed, &angular_momentum(&tensor, &now.angular_velocity), 4.0 * ROUNDING);
    // About another point of the body, with the moments about that point, the same holds.
    let pivot = Vector3::new(9.0, -3.0, 2.0);
    let tensor = tensor_in_world(now.attitude, &body.about(pivot).unwrap().tensor());
    let summed = cloud.angular_momentum(&now, &pivot);
    assert_close(&summed, &angular_momentum(&tensor, &now.angular_velocity), 4.0 * ROUNDING);
}

#[test]
fn forces_that_move_the_particles_add_up_to_newton_and_euler() {
    let (cloud, time) = (cloud(), 0.7);
    let (body, now) = (cloud.mass_properties().unwrap(), motion(0.7));
    let centre = body.centre_of_mass;
    // F = m a on each particle, with the motion's own accelerations.
    let force = |particle: &Particle| {
        let in_body = particle.position - centre;
        PointForce { force: now.acceleration_of(&in_body) * particle.mass, point: now.position_of(&in_body) }
    };
    let forces: Vec<PointForce> = cloud.particles().iter().map(force).collect();
    let acceleration = acceleration_of_centre(&total_force(&forces), cloud.mass());
    assert_close(&acceleration, &now.acceleration, 4.0 * ROUNDING);
    let moment = total_moment(&forces, &now.position);
    // dL/dt = T.
    let momentum = |t| {
        let then = motion(t);
        angular_momentum(&tensor_in_world(then.attitude, &body.tensor()), &then.angular_velocity)
    };
    assert_close(&moment, &rate(momentum, time), DIFFERENCE);
    // α = I⁻¹ (T − ω × L) gives the motion's own α back.
    let alpha = angular_acceleration(&body, now.attitude, &now.angular_velocity, &moment);
    assert_close(&alpha, &now.angular_acceleration, 24.0 * ROUNDING);
}

#[test]
fn internal_forces_neither_push_nor_turn() {
    let (cloud, now) = (cloud(), motion(0.7));
    let positions: Vec<_> = cloud.particles().iter().map(|particle| now.position_of(&particle.position)).collect();
    let pairs = (0..positions.len()).flat_map(|first| (0..first).map(move |second| [first, second]));
    let spring = |ends: [usize; 2]| Spring { ends, stiffness: [1e4, 5e3, 3e3, 2e3][ends[1]], rest_length: 0.9 };
    let springs: Vec<Spring> = pairs.map(spring).collect();
    let forces = spring_forces(&positions, &springs).unwrap();
    let gross: f64 = forces.iter().map(|point_force| point_force.force.norm()).sum();
    assert!(gross > 1e4);
    let arm = positions.iter().map(|position| (position - now.position).norm()).fold(0.0, f64::max);
    let net = internal_resultant(&positions, &springs, &now.position).unwrap();
    assert!(net.force.norm() <= ROUNDING * gross, "{:e} N of {gross:e}", net.force.norm());
    assert!(net.moment.norm() <= ROUNDING * gross * arm, "{:e} N m", net.moment.norm());
}

#[test]
fn springs_that_cannot_be_are_refused() {
    let positions = [Vector3::zeros(), Vector3::x(), Vector3::x()];
    for ends in [[0, 3], [1, 1], [1, 2]] {
        let spring = Spring { ends, stiffness: 1.0, rest_length: 1.0 };
        let refused = spring_forces(&positions, &[spring]).unwrap_err();
        assert_eq!(refused, BodyError::Spring { index: 0, ends, particles: 3 });
    }
}

#[test]
fn clouds_without_width_are_refused_in_words() {
    assert_eq!(ParticleCloud::new(vec![]).unwrap_err(), BodyError::Empty("particles"));
    let at = |mass, position| Particle { mass, position };
    for mass in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = ParticleCloud::new(vec![at(1.0, Vector3::x()), at(mass, Vector3::y())]).unwrap_err();
        assert!(refused.to_string().starts_with("particle 1 has mass"), "{refused}");
    }
    let along = Vector3::new(0.3, -1.7, 0.9);
    for direction in [along, Vector3::x(), Vector3::zeros()] {
        let line = (0..7).map(|step| at(0.3, Vector3::new(5.0, 6.0, 7.0) + direction * f64::from(step))).collect();
        let refused = ParticleCloud::new(line).unwrap().mass_properties().unwrap_err();
        assert!(refused.to_string().starts_with("7 particles on one line"), "{refused}");
    }
    // Three off one line are a lamina: the largest moment is the sum of the others.
    let lamina = vec![at(1.0, along), at(2.0, Vector3::x()), at(3.0, Vector3::zeros())];
    let moments = ParticleCloud::new(lamina).unwrap().mass_properties().unwrap().moments.vector();
    assert!((moments.sum() - 2.0 * moments.max()).abs() <= 2.0 * ROUNDING * moments.max());
}
