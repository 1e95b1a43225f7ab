//! A body that is held at a point takes every load that does not ask where it goes: L about that point changes by the
//! moment about it, gravity's among them.

use nalgebra::Vector3;
use polhode::scenario::{Plan, Scenario};
use polhode::telemetry::{BodySamples, Channel};

/// From the body's origin, m.
const PIVOT: [f64; 3] = [0.0, 0.02, -0.3];

/// Each with what it is called, all acting at half a second.
const LOADS: [(&str, &str); 16] = [
    ("constant_body", "[[body.force.constant_body]]\nforce_n = [0.1, 0, 0.3]\npoint_m = [0, 0, 1]"),
    ("constant_world", "[[body.torque.constant_world]]\nmoment_n_m = [0.1, 0, 0.3]"),
    ("linear_damping", "[[body.torque.linear_damping]]\ncoefficient_n_m_s = 0.1"),
    ("momentum_brake", "[[body.torque.momentum_brake]]\nrate_per_s = 0.3"),
    ("magnetic_dipole", "[[body.torque.magnetic_dipole]]\ndipole_a_m2 = [0, 0, 1]\nfield_t = [1, 0, 0]"),
    (
        "table of a force",
        "[[body.force.table]]\nframe = \"world\"\npoint_m = [0, 0, 1]\nrows = [[0, 0, 0, 0], [1, 1, 0, 0]]",
    ),
    (
        "thruster",
        "[[body.force.thruster]]\ndirection = [1, 0, 0]\nthrust_n = 1\npoint_m = [0, 0, 1]\npulses_s = [[0.1, 0.9]]",
    ),
    (
        "quaternion_feedback",
        "[[body.torque.quaternion_feedback]]\ntarget = [1, 0, 0, 0]\nattitude_gain_n_m = 1\nrate_gain_n_m_s = 1",
    ),
    ("rate_feedback", "[[body.torque.rate_feedback]]\ngain_n_m_s = 1"),
    ("b_dot", "[[body.torque.b_dot]]\nfield_t = [1e-3, 0, 0]\ngain_a_m2_s_per_t = 1e5"),
    ("inner_sphere", "[[body.torque.inner_sphere]]\ninertia_kg_m2 = 0.01\ncoefficient_n_m_s = 0.1"),
    ("rotor", "[[body.rotor]]\naxis = [0, 0, 1]\nmomentum_n_m_s = 1"),
    (
        "formula of a force",
        "[[body.force.formula]]\nforce_n = [\"sin(2*t)\", \"wx\", \"0\"]\nframe = \"world\"\npoint_m = [0, 0, 1]",
    ),
    (
        "spring",
        "[[body.force.spring]]\nanchor_m = [0.2, 0, 2]\npoint_m = [0, 0, 1]\nstiffness_n_per_m = 10\nrest_length_m = 0.5\n\
         damping_n_s_per_m = 0.1",
    ),
    ("quadratic_drag", "[[body.force.quadratic_drag]]\ncoefficient_kg_per_m = 0.1\npoint_m = [0, 0, 1]"),
    ("quadratic_damping", "[[body.torque.quadratic_damping]]\ncoefficient_n_m_s2 = 0.1"),
];

fn sampled(load: &str, channels: &[Channel], times: &[f64]) -> BodySamples {
    let [x, y, z] = PIVOT;
    let text = format!(
        "duration_s = 1.0\nsample_every_s = 0.01\n[[body]]\nmass_kg = 2\nprincipal_moments_kg_m2 = [0.1, 0.2, 0.25]\n\
         angular_velocity_rad_s = [0.3, 1, 2]\ngravity_m_s2 = [0, 0, -9.81]\n[body.pivot]\nposition_m = [{x}, {y}, {z}]\n{load}\n"
    );
    let scenario = Scenario::parse(&text, "held.toml", &[]).expect("a scene");
    let plan = Plan::new(&scenario).unwrap_or_else(|error| panic!("{error}"));
    plan.bodies[0].sample(channels, times).expect("a finite motion")
}

fn vector(samples: &BodySamples, channel: Channel, index: usize) -> Vector3<f64> {
    let columns = samples.channel(channel).expect("watched");
    Vector3::from_fn(|row, _| columns[row][index])
}

/// By central differences of fourth order over 1 ms: what changes within 0.1 s leaves them off by 1e-9 of it, rounding by 1e-12.
#[test]
fn momentum_about_the_pivot_changes_by_the_moment_about_it() {
    let (time, step) = (0.5, 1e-3);
    let times = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|steps| time + steps * step);
    for (name, load) in LOADS {
        let samples = sampled(load, &[Channel::AngularMomentumWorld, Channel::MomentWorld], &times);
        let [before, left, _, right, after] =
            [0, 1, 2, 3, 4].map(|index| vector(&samples, Channel::AngularMomentumWorld, index));
        let rate = ((right - left) * 8.0 - (after - before)) / (12.0 * step);
        let moment = vector(&samples, Channel::MomentWorld, 2);
        assert!(moment.norm() > 0.1, "{name}: gravity alone pulls");
        assert!((rate - moment).norm() <= 1e-8 * moment.norm(), "{name}: {rate} is not {moment}");
    }
}

/// Against a moment made by hand: (x − pivot) × F, of gravity at the centre of mass and a spring at a point.
#[test]
fn a_spring_pulls_about_the_pivot() {
    let (_, load) = LOADS.into_iter().find(|(name, _)| *name == "spring").expect("a spring");
    let load = load.replace("damping_n_s_per_m = 0.1", "");
    let samples = sampled(&load, &[Channel::Attitude, Channel::MomentWorld], &[0.7]);
    let attitude = samples.channel(Channel::Attitude).expect("watched");
    let [w, i, j, k] = [0, 1, 2, 3].map(|column: usize| attitude[column][0]);
    let turn = nalgebra::UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(w, i, j, k));
    let pivot = Vector3::from(PIVOT);
    let (centre, point) = (turn * -pivot, turn * (Vector3::z() - pivot));
    // The pivot is the world's origin, where the body's position was put.
    let reach = point - Vector3::new(0.2, 0.0, 2.0);
    let force = -10.0 * (reach.norm() - 0.5) * reach.normalize();
    let due = centre.cross(&Vector3::new(0.0, 0.0, -2.0 * 9.81)) + point.cross(&force);
    let found = vector(&samples, Channel::MomentWorld, 0);
    assert!((found - due).norm() <= 1e-14 * due.norm(), "{found} is not {due}");
}
