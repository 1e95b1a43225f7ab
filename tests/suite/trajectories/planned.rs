//! Runs of scenes: mass properties, principal axes, paths chosen by the plan, every channel.

use polhode::scenario::{BodySpec, BoxSpec, ForceSpec, ParticleSpec, Plan, Scenario};
use polhode::telemetry::Channel;

use super::Hash;

pub fn lines() -> Vec<String> {
    let tensor =
        BodySpec { inertia_kg_m2: Some([[2.0, 0.1, -0.2], [0.1, 2.5, 0.3], [-0.2, 0.3, 3.0]]), ..thrown("tensor") };
    let particle = |mass_kg, position_m| ParticleSpec { name: None, mass_kg, position_m };
    let particles = BodySpec {
        particle: vec![
            particle(1.0, [0.1, 0.0, 0.0]),
            particle(2.0, [-0.3, 0.4, 0.0]),
            particle(0.7, [0.2, -0.1, 0.5]),
            particle(0.3, [0.0, 0.3, -0.4]),
        ],
        ..thrown("particles")
    };
    let mut solids = BodySpec { gravity_m_s2: Some([0.0, 0.0, -9.81]), ..thrown("solids") };
    let block = |size_m, position_m, rotation| BoxSpec {
        size_m,
        mass_kg: Some(1.5),
        density_kg_m3: None,
        position_m: Some(position_m),
        rotation: Some(rotation),
    };
    solids.solid.cuboid = vec![
        block([0.2, 0.3, 0.25], [0.0, 0.0, 0.125], [1.0, 0.0, 0.0, 0.0]),
        block([0.2, 0.3, 0.25], [0.1, 0.0, -0.2], [0.8, 0.0, 0.6, 0.0]),
    ];
    let mut pushed = BodySpec { name: "pushed".into(), ..solids.clone() };
    pushed.force.constant_body =
        vec![ForceSpec { force_n: [1.0, -0.5, 0.3], point_m: [0.1, 0.2, 0.0], start_s: Some(0.3), end_s: Some(1.7) }];
    let derived = derived(&tensor);
    [tensor, particles, solids, pushed].map(|body| line(&body)).into_iter().chain([derived]).collect()
}

fn thrown(name: &str) -> BodySpec {
    BodySpec {
        name: name.into(),
        angular_velocity_rad_s: Some([0.3, 4.0, -0.2]),
        velocity_m_s: Some([0.1, 0.2, 5.0]),
        ..BodySpec::default()
    }
}

fn line(body: &BodySpec) -> String {
    // A thruster leaves neither energy nor momentum a law.
    let drifts = [Channel::EnergyDrift, Channel::MomentumDrift, Channel::Slip];
    // These bodies have no axis of symmetry.
    let leaning = [Channel::Tilt, Channel::PrecessionRate];
    let is_free = body.force.constant_body.is_empty();
    let is_told = |channel: &Channel| {
        *channel < Channel::EulerZxz && !leaning.contains(channel) && (is_free || !drifts.contains(channel))
    };
    let channels: Vec<_> = Channel::ALL.into_iter().filter(is_told).collect();
    hash(body, &channels).line(&format!("scene, {}", body.name))
}

/// What is derived of a free body of three different moments.
fn derived(body: &BodySpec) -> String {
    let of_others = [Channel::JacobiIntegral, Channel::KovalevskayaIntegral];
    let derived = Channel::EulerZxz..=Channel::KovalevskayaIntegral;
    let is_told = |channel: &Channel| derived.contains(channel) && !of_others.contains(channel);
    let channels: Vec<_> = Channel::ALL.into_iter().filter(is_told).collect();
    hash(body, &channels).line(&format!("scene, derived of {}", body.name))
}

fn hash(body: &BodySpec, channels: &[Channel]) -> Hash {
    let scenario = Scenario {
        duration_s: Some(3.0),
        sample_every_s: Some(0.01),
        channels: Some(channels.iter().map(|channel| channel.row().name.to_owned()).collect()),
        body: vec![body.clone()],
        ..Scenario::default()
    };
    let plan = Plan::new(&scenario).unwrap_or_else(|error| panic!("{}: {error}", body.name));
    let mut run = plan.start().expect("covered");
    let mut hash = Hash::EMPTY;
    while let Some(samples) = run.next_batch().expect("a finite motion") {
        samples.bodies[0].columns().iter().flatten().for_each(|value| hash.add(*value));
    }
    hash
}
