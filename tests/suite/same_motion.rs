//! One body, described in several ways, moves in one way.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use polhode::scenario::{Plan, Scenario};
use polhode::telemetry::Channel;

/// A box of 0.2 × 0.3 × 0.5 m and 3 kg, thrown to tumble.
const MOMENTS: [f64; 3] = [0.085, 0.0725, 0.0325];
const OMEGA: [f64; 3] = [0.3, 4.0, -0.2];
/// Roundings of the mass properties (a few 1e-16), grown over six turns and the flips between them.
const LIMIT: f64 = 5e-13;

/// Attitude at 10 s of the one body in `body` (TOML), with a torque where `load` says so.
fn attitude_at_the_end(body: &str, load: &str) -> UnitQuaternion<f64> {
    let text = format!("sample_times_s = [10.0]\nchannels = [\"attitude\"]\n\n[[body]]\n{body}\n{load}\n");
    let scenario = Scenario::parse(&text, "box", &[]).unwrap_or_else(|error| panic!("{error}"));
    let plan = Plan::new(&scenario).unwrap_or_else(|error| panic!("{error}"));
    let mut run = plan.start().expect("covered");
    let samples = run.next_batch().expect("propagated").expect("one sample");
    let [w, x, y, z] = samples.bodies[0].channel(Channel::Attitude).expect("asked for") else { panic!("four columns") };
    UnitQuaternion::new_unchecked(Quaternion::new(w[0], x[0], y[0], z[0]))
}

fn descriptions() -> Vec<(&'static str, String)> {
    let spin = format!("angular_velocity_rad_s = {OMEGA:?}\n");
    let solid = "[[body.solid.box]]\nsize_m = [0.2, 0.3, 0.5]\nmass_kg = 3.0\n";
    let halves = "[[body.solid.box]]\nsize_m = [0.2, 0.3, 0.25]\nmass_kg = 1.5\nposition_m = [0, 0, 0.125]\n\
                  [[body.solid.box]]\nsize_m = [0.2, 0.3, 0.25]\nmass_kg = 1.5\nposition_m = [0, 0, -0.125]\n";
    // Eight particles on the corners of a box smaller by √3 have the same moments.
    let (a, b, c) = (0.1 / 3.0_f64.sqrt(), 0.15 / 3.0_f64.sqrt(), 0.25 / 3.0_f64.sqrt());
    let corner = |signs: u8| {
        let sign = |bit: u8| if signs >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let position = [a * sign(0), b * sign(1), c * sign(2)];
        format!("[[body.particle]]\nmass_kg = 0.375\nposition_m = {position:?}\n")
    };
    vec![
        ("moments", format!("mass_kg = 3.0\nprincipal_moments_kg_m2 = {MOMENTS:?}\n{spin}")),
        ("solid", format!("{spin}{solid}")),
        ("two halves", format!("{spin}{halves}")),
        ("particles", spin + &(0..8).map(corner).collect::<String>()),
    ]
}

/// The same body in axes turned by `body_from_tilted`: a full tensor, and every body vector turned.
fn tilted(body_from_tilted: UnitQuaternion<f64>) -> String {
    let rotation = body_from_tilted.to_rotation_matrix();
    let tensor = rotation.inverse() * Matrix3::from_diagonal(&Vector3::from(MOMENTS)) * rotation;
    let tensor = 0.5 * (tensor + tensor.transpose());
    let rows: Vec<[f64; 3]> = (0..3).map(|row| [tensor[(row, 0)], tensor[(row, 1)], tensor[(row, 2)]]).collect();
    let omega = body_from_tilted.inverse() * Vector3::from(OMEGA);
    let q = body_from_tilted;
    format!(
        "mass_kg = 3.0\ninertia_kg_m2 = {rows:?}\nattitude = {:?}\nangular_velocity_rad_s = {:?}\n",
        [q.w, q.i, q.j, q.k],
        [omega.x, omega.y, omega.z]
    )
}

#[test]
fn however_described_a_box_tumbles_alike() {
    for load in ["", "[[body.torque.constant_world]]\nmoment_n_m = [0.01, -0.02, 0.03]\nstart_s = 1.2345\n"] {
        let reference = attitude_at_the_end(&descriptions()[0].1, load);
        for (name, body) in descriptions() {
            let error = reference.angle_to(&attitude_at_the_end(&body, load));
            assert!(error <= LIMIT, "{name}: {error:e} rad");
        }
        let body_from_tilted = UnitQuaternion::new(Vector3::new(0.4, -0.7, 0.2));
        let turned = attitude_at_the_end(&tilted(body_from_tilted), load) * body_from_tilted.inverse();
        let error = reference.angle_to(&turned);
        assert!(error <= LIMIT, "tilted axes: {error:e} rad");
    }
}

#[test]
fn two_half_windows_are_one() {
    let body = &descriptions()[0].1;
    let window = |start: f64, end: f64| {
        format!("[[body.torque.constant_body]]\nmoment_n_m = [0.1, 0.0, -0.05]\nstart_s = {start}\nend_s = {end}\n")
    };
    let whole = attitude_at_the_end(body, &window(1.1, 3.7));
    let halves = attitude_at_the_end(body, &(window(1.1, 2.3) + &window(2.3, 3.7)));
    let error = whole.angle_to(&halves);
    assert!(error <= LIMIT, "{error:e} rad");
}
