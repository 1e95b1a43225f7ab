//! Particles on springs: what a rigid body is derived from, and how near they come to it.

use std::sync::Arc;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude, Particle, ParticleCloud, State};
use polhode::dynamics::{DynamicsError, General, GeneralLoad, Load, Problem, SpringCloud, Springs, Torque, Window};
use polhode::propagation::{
    Dop853, FreeRotation, PreciseTaylor, PropagationError, States, Taylor, attitude_distance, attitude_distances,
};

use crate::motions::{grid, row, run};

/// The tightest tolerance of a step.
const TIGHTEST: f64 = 1e-16;
/// A few roundings.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Four particles, the fewest that fill space: a handle whose axis of the middle moment is z.
fn handle() -> ParticleCloud {
    let at = |mass, [x, y, z]: [f64; 3]| Particle { mass, position: Vector3::new(x, y, z) };
    let particles = [
        at(0.1, [0.0, 0.1, 0.04]),
        at(0.1, [0.0, -0.1, 0.04]),
        at(0.05, [0.04, 0.0, -0.08]),
        at(0.05, [-0.04, 0.0, -0.08]),
    ];
    ParticleCloud::new(particles.to_vec()).expect("a cloud")
}

fn springs(stiffness: f64) -> Springs {
    Springs { stiffness, damping: 0.0, is_relaxed: false }
}

fn joined(cloud: &ParticleCloud, springs: Springs) -> Result<Load, DynamicsError> {
    let body = cloud.mass_properties().expect("a body");
    let kind = General::Cloud(SpringCloud::new(cloud, &body, springs)?);
    Ok(Load { torque: Torque::General(Arc::new(GeneralLoad::new(kind))), window: Window::ALWAYS })
}

/// The handle, tilted, spinning near its middle axis: rigid without springs.
fn problem(springs: Option<Springs>) -> Problem {
    let cloud = handle();
    let body = cloud.mass_properties().expect("a body");
    let tilted = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 1.1, -0.7));
    Problem {
        moments: body.moments,
        mass: body.mass,
        initial: State {
            attitude: Attitude::from_world_from_body(tilted),
            angular_velocity: AngularVelocity::from_vector(Vector3::new(0.08, 0.0, 4.0)),
            position: Vector3::new(1.0, -2.0, 3.0),
            velocity: Vector3::new(0.5, 0.0, 2.0),
        },
        loads: springs.map(|springs| joined(&cloud, springs).expect("held")).into_iter().collect(),
        gravity: Vector3::new(0.0, 0.0, -9.81),
        wants_attitude: true,
        wants_translation: true,
    }
}

fn by_taylor(springs: Springs, times: &[f64]) -> States {
    run(Taylor::new(&problem(Some(springs)), TIGHTEST).expect("covered"), times)
}

/// Masses, places from the centre of mass, velocities relative to it and forces, in one row.
fn particles(states: &States, index: usize) -> Vec<(f64, [Vector3<f64>; 3])> {
    let of = |columns: &[Vec<f64>; 3]| Vector3::from(row(columns, index));
    let masses = handle().particles().iter().map(|particle| particle.mass).collect::<Vec<_>>();
    masses
        .into_iter()
        .zip(&states.cloud.particles)
        .map(|(mass, p)| (mass, [of(&p.arm), of(&p.velocity), of(&p.force)]))
        .collect()
}

fn momentum(states: &States, index: usize) -> Vector3<f64> {
    particles(states, index).iter().map(|(mass, [arm, velocity, _])| arm.cross(velocity) * *mass).sum()
}

fn energy(states: &States, index: usize) -> f64 {
    states.cloud.kinetic_energy[index] + states.cloud.elastic_energy[index]
}

/// What a spring gives to one particle it takes from another, in the same digits, and along the line between them: only
/// the adding rounds.
#[test]
fn forces_of_springs_leave_neither_force_nor_moment() {
    let (states, mut largest) = (by_taylor(springs(400.0), &grid(5.0, 300)), 0.0_f64);
    for index in 0..states.len() {
        let each = particles(&states, index);
        let net: Vector3<f64> = each.iter().map(|(_, [_, _, force])| *force).sum();
        let turning: Vector3<f64> = each.iter().map(|(_, [arm, _, force])| arm.cross(force)).sum();
        let gross: f64 = each.iter().map(|(_, [_, _, force])| force.norm()).sum();
        let gross_turning: f64 = each.iter().map(|(_, [arm, _, force])| arm.norm() * force.norm()).sum();
        assert!(net.norm() <= ROUNDING * gross, "{:e} N of {gross}", net.norm());
        assert!(turning.norm() <= ROUNDING * gross_turning, "{:e} N m of {gross_turning}", turning.norm());
        largest = gross.max(largest);
    }
    assert!(largest > 0.5, "{largest} N");
}

/// So the momenta of all together stay, and without dampers the energy too; and the channels' L = R I₀ ω is that of the
/// particles.
#[test]
fn momenta_and_energy_of_all_particles_stay() {
    let states = by_taylor(springs(400.0), &grid(5.0, 300));
    let moments = problem(None).moments.vector();
    let (first, size) = (momentum(&states, 0), momentum(&states, 0).norm());
    for index in 0..states.len() {
        assert!((momentum(&states, index) - first).norm() <= 4.0 * ROUNDING * size);
        assert!((energy(&states, index) / energy(&states, 0) - 1.0).abs() <= 4.0 * ROUNDING);
        let each = particles(&states, index);
        let whole: Vector3<f64> = each.iter().map(|(mass, [_, velocity, _])| velocity * *mass).sum();
        let gross: f64 = each.iter().map(|(mass, [_, velocity, _])| velocity.norm() * mass).sum();
        assert!(whole.norm() <= ROUNDING * gross, "{:e} N s of {gross}", whole.norm());
        let [w, x, y, z] = row(&states.attitude, index);
        let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        let told = attitude * moments.component_mul(&Vector3::from(row(&states.angular_velocity, index)));
        assert!((told - first).norm() <= 8.0 * ROUNDING * size);
    }
    // The centre of mass falls as a stone does.
    let end = states.len() - 1;
    assert_eq!(states.position.each_ref().map(|column| column[end]), [3.5, -2.0, 3.0 + 5.0 * (2.0 - 0.5 * 9.81 * 5.0)]);
}

/// m dv/dt is the force recorded: by central differences of fourth order, off by the fourth power of 2 ms times the
/// vibrations' frequency, 148 rad/s at most.
#[test]
fn every_particle_obeys_force_is_mass_times_acceleration() {
    let (step, count) = (1e-4, 400);
    let times: Vec<f64> = (0..=count).map(|i| step * f64::from(i)).collect();
    let states = by_taylor(springs(400.0), &times);
    for index in (10..states.len() - 10).step_by(7) {
        let velocity =
            |index| particles(&states, index).into_iter().map(|(_, [_, velocity, _])| velocity).collect::<Vec<_>>();
        let around = [index - 2, index - 1, index + 1, index + 2].map(velocity);
        for (particle, (mass, [_, _, force])) in particles(&states, index).into_iter().enumerate() {
            let [before, left, right, after] = around.each_ref().map(|all| all[particle]);
            let rate = ((right - left) * 8.0 - (after - before)) / (12.0 * step);
            assert!((rate * mass - force).norm() <= 2e-7 * force.norm().max(0.1), "{:e}", (rate * mass - force).norm());
        }
    }
}

/// Springs stretch by (ω/Ω)² of their length, Ω² ∝ k, so the moments of inertia are off by that much, and the angle turned
/// at the same L: four times stiffer, four times closer, whether the springs start stretched or not.
#[test]
fn four_times_stiffer_springs_keep_four_times_closer_to_the_rigid_body() {
    let times = grid(2.0, 40);
    let rigid = run(FreeRotation::new(&problem(None)).expect("covered"), &times);
    for is_relaxed in [false, true] {
        let departure = |stiffness| {
            let springs = Springs { is_relaxed, ..springs(stiffness) };
            let [lowest, _] = problem(Some(springs))
                .loads
                .first()
                .map_or([0.0; 2], |_| problem(Some(springs)).cloud().expect("a cloud").natural_frequencies());
            let angle = attitude_distances(&rigid, &by_taylor(springs, &times)).last().expect("an angle");
            // In strains times the 8 rad turned.
            let scaled = angle / ((4.0 / lowest).powi(2) * 8.0);
            assert!((0.5..2.0).contains(&scaled), "{scaled}");
            angle
        };
        let angles = [400.0, 1600.0, 6400.0, 25600.0].map(departure);
        for (pair, room) in angles.windows(2).zip([0.1, 0.05, 0.02]) {
            let ratio = pair[0] / pair[1];
            assert!((ratio - 4.0).abs() <= room, "relaxed {is_relaxed}: {ratio}");
        }
    }
}

/// A triangle of equal masses spins about its axis. The springs stretch it by x = (ω/Ω)², Ω² = 3k/m: at the same L it turns
/// slower by 2x. Springs without force at first let it swing between no stretch and twice that.
#[test]
fn a_spinning_triangle_falls_behind_as_its_formula() {
    let (mass, spin, end) = (0.2, 3.0, 2.0);
    let corner = |angle: f64| Particle { mass, position: 0.1 * Vector3::new(libm::cos(angle), libm::sin(angle), 0.0) };
    let third = std::f64::consts::TAU / 3.0;
    let cloud = ParticleCloud::new(vec![corner(0.0), corner(third), corner(2.0 * third)]).expect("a cloud");
    let body = cloud.mass_properties().expect("a body");
    let start = problem(None);
    let initial =
        State { angular_velocity: AngularVelocity::from_vector(Vector3::new(0.0, 0.0, spin)), ..start.initial };
    let rigid = Problem { moments: body.moments, mass: body.mass, initial, wants_translation: false, ..start };
    let times = [0.3 * end, end];
    let turned = run(FreeRotation::new(&rigid).expect("covered"), &times);
    for (stiffness, is_relaxed) in [(1e3, false), (1e3, true), (1e5, false), (1e5, true)] {
        let frequency = (3.0 * stiffness / mass).sqrt();
        let strain = (spin / frequency).powi(2);
        let loads = vec![joined(&cloud, Springs { is_relaxed, ..springs(stiffness) }).expect("held")];
        let states = run(Taylor::new(&Problem { loads, ..rigid.clone() }, TIGHTEST).expect("covered"), &times);
        for (time, behind) in times.iter().zip(attitude_distances(&turned, &states)) {
            let swing = if is_relaxed { 0.0 } else { libm::sin(frequency * time) / frequency };
            let expected = 2.0 * strain * spin * (time - swing);
            // The next order in x, and in the swing's phase, which is off by x Ω t.
            let room = 10.0 * strain * (1.0 + strain * frequency * time) + 1e-15 / expected;
            assert!((behind / expected - 1.0).abs() <= room, "k = {stiffness}, {is_relaxed}: {behind:e}, {expected:e}");
        }
    }
}

/// The same equations in double-double: to the roundings of some hundred steps, which the flips between magnify.
#[test]
fn the_run_in_f64_is_that_in_double_double() {
    let times = grid(2.0, 8);
    for damping in [0.0, 0.05] {
        let springs = Springs { damping, ..springs(400.0) };
        let states = by_taylor(springs, &times);
        let problem = problem(Some(springs));
        let mut exact = PreciseTaylor::new(&problem).expect("covered");
        for (index, time) in times.iter().enumerate() {
            let exact = exact.at(*time).expect("finite").expect("within reach");
            let q = exact.attitude.iter().zip(row(&states.attitude, index));
            let w = exact.angular_velocity.iter().zip(row(&states.angular_velocity, index));
            let x = exact.position.iter().zip(row(&states.position, index));
            for (exact, found) in q.chain(w).chain(x) {
                assert!((exact.hi() - found).abs() <= 2e-14, "{:e} at {time} s", exact.hi() - found);
            }
        }
    }
}

/// Dampers are internal too: energy goes, L stays.
#[test]
fn dampers_take_energy_and_leave_angular_momentum() {
    let states = by_taylor(Springs { damping: 0.2, ..springs(400.0) }, &grid(10.0, 400));
    let (first, last) = (momentum(&states, 0), states.len() - 1);
    for index in 1..states.len() {
        assert!((momentum(&states, index) - first).norm() <= 4.0 * ROUNDING * first.norm());
        assert!(energy(&states, index) <= energy(&states, index - 1) * (1.0 + ROUNDING), "at row {index}");
    }
    // What vibrates at first, the springs being suddenly loaded, is a thousandth of the energy; the rest goes slowly.
    assert!(energy(&states, last) < 0.9995 * energy(&states, 0));
}

/// With the springs stretched at the start, their forces are those that hold particles on their paths in a rigid body, to
/// the vibration that is left, of the relative size ω/Ω; without, they vibrate between nothing and twice that.
#[test]
fn relaxed_springs_pull_as_a_rigid_body_needs() {
    let springs = Springs { is_relaxed: true, ..springs(6400.0) };
    let states = by_taylor(springs, &grid(0.5, 50));
    let problem = problem(Some(springs));
    let [lowest, _] = problem.cloud().expect("a cloud").natural_frequencies();
    let moments = problem.moments.vector();
    for index in 0..states.len() {
        let [w, x, y, z] = row(&states.attitude, index);
        let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        let in_body = Vector3::from(row(&states.angular_velocity, index));
        let rate = -in_body.cross(&moments.component_mul(&in_body)).component_div(&moments);
        let (omega, alpha) = (attitude * in_body, attitude * rate);
        for (mass, [arm, _, force]) in particles(&states, index) {
            let needed = mass * (omega.cross(&omega.cross(&arm)) + alpha.cross(&arm));
            assert!(
                (force - needed).norm() <= 4.0 / lowest * needed.norm(),
                "{:e}",
                (force - needed).norm() / needed.norm()
            );
        }
    }
}

/// The attitude starts where it was put, and its quaternion never jumps to the other sign.
#[test]
fn the_attitude_of_the_whole_is_continuous() {
    let states = by_taylor(springs(100.0), &grid(12.0, 1200));
    let start: [f64; 4] = problem(None).initial.attitude.wxyz();
    for (found, start) in row(&states.attitude, 0).iter().zip(start) {
        assert!((found - start).abs() <= ROUNDING);
    }
    for index in 1..states.len() {
        let (before, now) = (row(&states.attitude, index - 1), row(&states.attitude, index));
        let product: f64 = before.iter().zip(now).map(|(before, now)| before * now).sum();
        assert!(product > 0.999, "{product} at row {index}");
    }
    // Sampled thinly it is the same attitude, to the bit.
    let thin = by_taylor(springs(100.0), &grid(12.0, 12));
    assert_eq!(row(&thin.attitude, 12), row(&states.attitude, 1200));
}

#[test]
fn clouds_that_springs_do_not_hold_are_refused() {
    let at = |x: f64, y: f64, z: f64| Particle { mass: 1.0, position: Vector3::new(x, y, z) };
    let flat =
        ParticleCloud::new(vec![at(0., 0., 0.), at(1., 0., 1.), at(0., 1., 1.), at(1., 1., 2.)]).expect("a cloud");
    assert_eq!(joined(&flat, springs(1.0)).unwrap_err(), DynamicsError::SlackParticles);
    let twice =
        ParticleCloud::new(vec![at(0., 0., 0.), at(1., 0., 0.), at(0., 1., 0.), at(0., 1., 0.)]).expect("a cloud");
    assert_eq!(joined(&twice, springs(1.0)).unwrap_err(), DynamicsError::SlackParticles);
    let many = (0..17).map(|i| at(f64::from(i), f64::from(i * i % 7), f64::from(i * i * i % 5))).collect();
    let many = ParticleCloud::new(many).expect("a cloud");
    assert_eq!(joined(&many, springs(1.0)).unwrap_err(), DynamicsError::ManyParticles);
    // A triangle is held in its plane, which is all that it needs.
    let three = ParticleCloud::new(vec![at(0., 0., 0.), at(1., 0., 0.), at(0., 1., 0.)]).expect("a cloud");
    assert!(joined(&three, springs(1.0)).is_ok());
}

#[test]
fn particles_on_springs_are_followed_by_taylor_series_alone() {
    let alone = problem(Some(springs(400.0)));
    assert!(matches!(Dop853::new(&alone, 1e-12), Err(PropagationError::NotCovered { .. })));
    assert!(matches!(FreeRotation::new(&alone), Err(PropagationError::NotCovered { .. })));
    let mut loaded = alone.clone();
    loaded.loads.push(Load { torque: Torque::ConstantWorld { moment: Vector3::x() }, window: Window::ALWAYS });
    for refused in [Taylor::new(&loaded, TIGHTEST).err(), PreciseTaylor::new(&loaded).err()] {
        let message = refused.expect("refused").to_string();
        assert!(message.contains("nothing but uniform gravity"), "{message}");
    }
    // By other steps it is the same motion.
    let times = grid(2.0, 4);
    let loose = run(Taylor::new(&alone, 1e-12).expect("covered"), &times);
    let off = attitude_distance(&loose, &by_taylor(springs(400.0), &times));
    assert!(off > 0.0 && off < 1e-10, "{off:e}");
}
