use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::body::Attitude;
use polhode::body::particles::{RigidMotion, angular_acceleration};
use polhode::scenario::{Plan, Watched};
use polhode::telemetry::{BodySamples, Channel};

use super::{plan, recorded};

/// A body in general position: tilted axes, its centre of mass off its origin, a probe in each frame and an IMU.
const BODY: &str = r#"
duration_s = 4.0
sample_every_s = 0.25
channels = ["attitude", "angular_velocity", "angular_velocity_world", "moment_world", "position", "velocity",
            "acceleration", "position_body", "velocity_body", "acceleration_body"]

[[body]]
name = "box"
mass_kg = 2.0
inertia_kg_m2 = [[1.0, 0.2, -0.1], [0.2, 2.0, 0.3], [-0.1, 0.3, 2.6]]
centre_of_mass_m = [0.1, -0.2, 0.05]
attitude = [0.5, -0.1, 0.7, 0.5]
angular_velocity_rad_s = [0.7, -0.4, 1.1]
probe = [{ name = "world", point_m = [0.3, -0.2, 0.4] }, { name = "body", point_m = [0.3, -0.2, 0.4], frame = "body" }]
imu = [{ name = "imu", point_m = [0.3, -0.2, 0.4], attitude = [0.1, 0.7, -0.1, 0.7] }]
"#;

/// Body from sensor of the IMU in it.
const SENSOR: [f64; 4] = [0.1, 0.7, -0.1, 0.7];

/// What can act on it; all smooth but at times that no difference is taken across.
const ACTING: [(&str, &str); 9] = [
    ("nothing", "velocity_m_s = [0.3, 0.1, -0.2]"),
    ("gravity", "velocity_m_s = [0.3, 0.1, 2.0]\ngravity_m_s2 = [0.0, 0.5, -9.81]"),
    ("a pivot", "gravity_m_s2 = [0.0, 0.5, -9.81]\npivot = { position_m = [-0.3, 0.1, 0.2] }"),
    (
        "forces",
        r"gravity_m_s2 = [0.0, 0.0, -9.81]
        force.constant_body = [{ force_n = [1.0, 0.5, -0.7], point_m = [0.1, 0.3, 0.0] }]
        force.constant_world = [{ force_n = [-0.4, 0.9, 1.6], point_m = [0.0, 0.0, 0.5], start_s = 1.1 }]",
    ),
    (
        "rotors",
        r"rotor = [{ axis = [0.0, 0.6, 0.8], momentum_n_m_s = 0.7 }, { axis = [1.0, 0.0, 0.0],
            times_s = [0.0, 1.1, 4.0], momenta_n_m_s = [0.0, 0.5, -0.4] }]
        torque.linear_damping = [{ coefficient_n_m_s = 0.1 }]",
    ),
    (
        "a sphere inside",
        r"torque.inner_sphere = [{ inertia_kg_m2 = 0.4, coefficient_n_m_s = 0.3, relative_rate_rad_s = [0.5, 1.0, -0.8] }]
        torque.constant_body = [{ moment_n_m = [0.3, -0.2, 0.1] }]",
    ),
    (
        "controllers",
        r"torque.quaternion_feedback = [{ target = [1.0, 0.0, 0.0, 0.0], attitude_gain_n_m = 1.5, rate_gain_n_m_s = 0.8 }]
        force.spring = [{ anchor_m = [0.0, 0.0, 3.0], point_m = [0.1, 0.1, 0.0], stiffness_n_per_m = 5.0,
            rest_length_m = 1.0, damping_n_s_per_m = 0.3 }]
        force.quadratic_drag = [{ coefficient_kg_per_m = 0.4, point_m = [0.2, 0.0, 0.0] }]",
    ),
    (
        "formulae",
        r#"torque.formula = [{ moment_n_m = ["0.1*sin(2*t)", "0.2*wx", "-0.1"], frame = "body" }]
        force.formula = [{ force_n = ["cos(t)", "0.3*vz", "1"], frame = "world", point_m = [0.0, 0.2, 0.0] }]"#,
    ),
    (
        "an orbit",
        r"torque.gravity_gradient = [{ mean_motion_rad_s = 0.8 }]
        torque.magnetic_dipole = [{ dipole_a_m2 = [0.3, -0.4, 0.2], field_t = [0.2, -0.1, -0.15] }]",
    ),
];

fn acting(load: &str) -> Plan {
    // Keys of the body come before the tables in line of the loads.
    let attitude = "attitude = [0.5, -0.1, 0.7, 0.5]";
    plan(&BODY.replace(attitude, &format!("{attitude}\n{load}")))
}

fn watched<'a>(plan: &'a Plan, name: &str) -> Watched<'a> {
    plan.watched().find(|watched| watched.name() == name).expect("it is recorded")
}

fn vector(samples: &BodySamples, channel: Channel, index: usize) -> Vector3<f64> {
    let columns = samples.channel(channel).expect("it is recorded");
    Vector3::from_fn(|row, _| columns[row][index])
}

fn attitude(samples: &BodySamples, index: usize) -> UnitQuaternion<f64> {
    let columns = samples.channel(Channel::Attitude).expect("it is recorded");
    let [w, x, y, z] = [0, 1, 2, 3].map(|row| columns[row][index]);
    UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
}

/// Between the instants of a central difference, s.
const STEP: f64 = 0.005;
/// Times in the middle of differences: no load begins or ends within four steps of them.
const TIMES: [f64; 5] = [0.3, 0.77, 1.5, 2.4, 3.9];
/// Of a central difference of order 8.
const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];

/// The rate at which `channel` changes at `time`: 1e-17 from its ninth derivative, and 1e-12 from rounding at 20 m/s.
fn rate(watched: Watched, channel: Channel, time: f64) -> Vector3<f64> {
    let times: Vec<f64> = (-4..=4).map(|step| time + f64::from(step) * STEP).collect();
    let samples = watched.sample(&[channel], &times).expect("a motion");
    let pair = |(index, weight): (usize, f64)| {
        weight * (vector(&samples, channel, 5 + index) - vector(&samples, channel, 3 - index))
    };
    WEIGHTS.into_iter().enumerate().map(pair).sum::<Vector3<f64>>() / STEP
}

/// Velocity and acceleration are the derivatives of what is recorded as position and velocity, whatever acts: of a probe,
/// and of the body's own point.
#[test]
fn accelerations_are_derivatives_of_velocities_and_these_of_positions() {
    for (what, load) in ACTING {
        let plan = acting(load);
        for name in ["box", "box/world"] {
            let of = watched(&plan, name);
            for (first, second) in [(Channel::Position, Channel::Velocity), (Channel::Velocity, Channel::Acceleration)]
            {
                for time in TIMES {
                    let told = vector(&of.sample(&[second], &[time]).expect("a motion"), second, 0);
                    let off = (rate(of, first, time) - told).norm();
                    assert!(off < 4e-12, "{what}: {second:?} of {name} at {time} s is off by {off:e}");
                }
            }
        }
    }
}

/// What is told in body axes is what is told in world axes, turned: to the rounding of a turn.
#[test]
fn a_vector_has_the_same_components_in_body_axes_as_after_a_turn() {
    let pairs = [
        (Channel::Position, Channel::PositionBody),
        (Channel::Velocity, Channel::VelocityBody),
        (Channel::Acceleration, Channel::AccelerationBody),
    ];
    for (what, load) in ACTING {
        let plan = acting(load);
        let body = recorded(&plan, "box");
        for (world, own) in [("box", "box"), ("box/world", "box/body")] {
            let (in_world, in_body) = (recorded(&plan, world), recorded(&plan, own));
            for (index, (first, second)) in (0..17).flat_map(|index| pairs.map(|pair| (index, pair))) {
                let expected = vector(&in_world, first, index);
                let off = (attitude(&body, index) * vector(&in_body, second, index) - expected).norm();
                assert!(off < 1e-14 * (1.0 + expected.norm()), "{what}: {second:?} of {own} is off by {off:e}");
            }
        }
    }
}

/// v = ω × r + V and a = α × r + ω × (ω × r) + A, as the theory of particles says them, in world axes.
#[test]
fn a_probe_moves_as_a_point_of_a_rigid_body_does() {
    // No rotor and no sphere: α is I⁻¹ (T − ω × I ω).
    for (what, load) in ACTING.into_iter().filter(|(what, _)| !["rotors", "a sphere inside"].contains(what)) {
        let plan = acting(load);
        let (body, probe) = (recorded(&plan, "box"), recorded(&plan, "box/world"));
        let properties = &plan.bodies[0].properties;
        for index in 0..17 {
            let at = |channel| vector(&body, channel, index);
            let attitude = Attitude::from_world_from_body(attitude(&body, index));
            let angular_velocity = at(Channel::AngularVelocityWorld);
            let alpha = angular_acceleration(properties, attitude, &angular_velocity, &at(Channel::MomentWorld));
            let motion = RigidMotion {
                attitude,
                position: at(Channel::Position),
                velocity: at(Channel::Velocity),
                acceleration: at(Channel::Acceleration),
                angular_velocity,
                angular_acceleration: alpha,
            };
            let point = Vector3::new(0.3, -0.2, 0.4) - properties.about;
            let expected = [motion.position_of(&point), motion.velocity_of(&point), motion.acceleration_of(&point)];
            let channels = [Channel::Position, Channel::Velocity, Channel::Acceleration];
            for (channel, expected) in channels.into_iter().zip(expected) {
                let off = (vector(&probe, channel, index) - expected).norm();
                assert!(off < 2e-15 * (1.0 + expected.norm()), "{what}: {channel:?} is off by {off:e}");
            }
        }
    }
}

/// A gyroscope reads ω, an accelerometer what its point's acceleration and gravity differ by, both in their own axes.
#[test]
fn an_imu_reads_its_rates_and_the_specific_force_at_its_mounting() {
    let [w, x, y, z] = SENSOR;
    let body_from_sensor = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
    for (what, load) in ACTING.into_iter().filter(|(what, _)| *what != "an orbit") {
        let plan = acting(load);
        let gravity = match what {
            "gravity" | "a pivot" => Vector3::new(0.0, 0.5, -9.81),
            "forces" => Vector3::new(0.0, 0.0, -9.81),
            _ => Vector3::zeros(),
        };
        let [body, probe, imu] = ["box", "box/world", "box/imu"].map(|name| recorded(&plan, name));
        for index in 0..17 {
            let world_from_sensor = attitude(&body, index) * body_from_sensor;
            let rates = vector(&imu, Channel::Gyroscope, index);
            assert!((world_from_sensor * rates - vector(&body, Channel::AngularVelocityWorld, index)).norm() < 4e-15);
            let felt = world_from_sensor * vector(&imu, Channel::Accelerometer, index);
            let off = (felt - (vector(&probe, Channel::Acceleration, index) - gravity)).norm();
            assert!(off < 2e-14, "{what}: off by {off:e}");
        }
    }
}

/// A body that spins about a principal axis: a = −ω² r, whatever else of it is known.
#[test]
fn a_point_of_a_steady_spin_is_drawn_to_the_axis() {
    let scene = BODY
        .replace(
            "inertia_kg_m2 = [[1.0, 0.2, -0.1], [0.2, 2.0, 0.3], [-0.1, 0.3, 2.6]]",
            "principal_moments_kg_m2 = [1, 2, 2.6]",
        )
        .replace("centre_of_mass_m = [0.1, -0.2, 0.05]\n", "")
        .replace("[0.7, -0.4, 1.1]", "[0.0, 3.0, 0.0]");
    let probe = recorded(&plan(&scene), "box/body");
    for index in 0..17 {
        let off = vector(&probe, Channel::AccelerationBody, index) - Vector3::new(-9.0 * 0.3, 0.0, -9.0 * 0.4);
        assert!(off.norm() < 1e-15, "{off:?}");
    }
}

/// In free fall it feels nothing at the centre of mass, to the bit; held at a pivot, it feels what holds it.
#[test]
fn free_fall_is_not_felt_and_rest_is() {
    let at_centre =
        BODY.replace("name = \"imu\", point_m = [0.3, -0.2, 0.4]", "name = \"imu\", point_m = [0.1, -0.2, 0.05]");
    let falling = plan(&at_centre.replace("mass_kg", "gravity_m_s2 = [0.0, 0.0, -9.81]\nmass_kg"));
    let imu = recorded(&falling, "box/imu");
    assert!(imu.channel(Channel::Accelerometer).expect("recorded").iter().flatten().all(|value| *value == 0.0));
    let resting = at_centre
        .replace("mass_kg", "gravity_m_s2 = [0.0, 0.0, -9.81]\npivot = { position_m = [0.1, -0.2, 0.05] }\nmass_kg")
        .replace("attitude = [0.5, -0.1, 0.7, 0.5]\n", "")
        .replace("attitude = [0.1, 0.7, -0.1, 0.7]", "attitude = [0.5, 0.5, 0.5, 0.5]")
        .replace("angular_velocity_rad_s = [0.7, -0.4, 1.1]\n", "");
    let imu = recorded(&plan(&resting), "box/imu");
    // This sensor's y axis is the body's z axis.
    for index in 0..17 {
        let off = vector(&imu, Channel::Accelerometer, index) - Vector3::new(0.0, 9.81, 0.0);
        assert!(off.norm() < 4e-15, "{off:?}");
    }
}

/// A body that always turns the same side to the earth: what is farther out is pulled to it by 3 n² ρ, what is beside the
/// orbit is pressed to it by n² ρ, and what is ahead feels nothing.
#[test]
fn an_accelerometer_in_orbit_feels_the_gradient_of_gravity() {
    let scene = |point: [f64; 3]| {
        format!(
            r"
            duration_s = 40.0
            sample_every_s = 0.5
            [[body]]
            principal_moments_kg_m2 = [1.0, 2.0, 2.6]
            angular_velocity_rad_s = [0.0, 0.0, 0.25]
            torque.gravity_gradient = [{{ mean_motion_rad_s = 0.25 }}]
            imu = [{{ name = 'imu', point_m = {point:?} }}]
            "
        )
    };
    let square = 0.25 * 0.25;
    for (point, expected) in [
        ([2.0, 0.0, 0.0], Vector3::new(-3.0 * square * 2.0, 0.0, 0.0)),
        ([0.0, 2.0, 0.0], Vector3::zeros()),
        ([0.0, 0.0, 2.0], Vector3::new(0.0, 0.0, square * 2.0)),
    ] {
        let imu = recorded(&plan(&scene(point)), "body/imu");
        for index in 0..81 {
            let off = (vector(&imu, Channel::Accelerometer, index) - expected).norm();
            assert!(off < 2e-14, "{point:?}: off by {off:e}");
        }
    }
}

/// Whether anybody looks at a point of it is nothing to a body: not a bit of it changes.
#[test]
fn a_body_moves_as_it_does_without_probes() {
    for (what, load) in ACTING {
        let mut plan = acting(load);
        let with = recorded(&plan, "box");
        plan.bodies[0].points.clear();
        assert_eq!(with, recorded(&plan, "box"), "{what}");
    }
}

/// Only a gyroscope is asked for: no attitude is propagated, and none is missed.
#[test]
fn nothing_is_propagated_that_no_point_needs() {
    let scene = BODY.replace("channels = [", "channels = [\"angular_velocity\"]\nx = [");
    let scene: String = scene
        .lines()
        .filter(|line| !line.starts_with("x = ") && !line.starts_with("            \"acc"))
        .collect::<Vec<_>>()
        .join("\n");
    let with_probes = plan(&scene);
    assert!(with_probes.bodies[0].problem.wants_attitude && !with_probes.bodies[0].problem.wants_translation);
    let mut gyroscope = with_probes.bodies[0].clone();
    gyroscope.points.retain(|point| point.name == "box/imu");
    gyroscope.points[0].channels = vec![Channel::Gyroscope];
    let gyroscope = gyroscope.watching(&[Channel::AngularVelocity]);
    assert!(!gyroscope.problem.wants_attitude);
    let read = Watched { body: &gyroscope, point: Some(&gyroscope.points[0]) };
    let rates = read.sample(&[Channel::Gyroscope], &[1.0]).expect("a motion");
    let expected = recorded(&with_probes, "box/imu");
    assert!((vector(&rates, Channel::Gyroscope, 0) - vector(&expected, Channel::Gyroscope, 4)).norm() < 1e-15);
}
