//! Springs between the particles of a body.

use std::sync::Arc;

use crate::body::{MassProperties, ParticleCloud, State};
use crate::dynamics::{General, GeneralLoad, Load, SpringCloud, Springs, Torque, Window};
use crate::scenario::plan::mass::particles;
use crate::scenario::plan::rules::{not_negative, positive};
use crate::scenario::{BodySpec, ForceSpecs, Key, Refusal, SpringsSpec, TorqueSpecs};

/// (ω/Ω)² at most, Ω the lowest natural frequency: about what the spin stretches the springs by, of their length. More is
/// no rigid body any more, and tears it apart before long.
const MOST_STRAIN: f64 = 0.1;

/// Those of the body at `key`, if it has any, in principal axes.
pub fn plan(key: &Key, spec: &BodySpec, properties: &MassProperties, initial: &State) -> Result<Option<Load>, Refusal> {
    let Some(springs) = &spec.springs else { return Ok(None) };
    let place = key.field("springs");
    if spec.particle.is_empty() {
        return Err(place.refuse("needs particles: springs join those of [[body.particle]], every two of them"));
    }
    let contradictions = [
        (spec.pivot.is_some(), "pivot", "held at a point, particles would need a force there"),
        (!spec.rotor.is_empty(), "rotor", "a wheel inside needs a body that is rigid"),
        (
            !spec.probe.is_empty(),
            "probe",
            "a body that is not rigid has no points of its own; its particles are recorded",
        ),
        (!spec.imu.is_empty(), "imu", "a body that is not rigid has no points of its own; its particles are recorded"),
        (spec.torque != TorqueSpecs::default(), "torque", "which particle would it turn?"),
        (spec.force != ForceSpecs::default(), "force", "nothing but uniform gravity acts on particles on springs"),
    ];
    if let Some((_, field, rule)) = contradictions.into_iter().find(|(given, ..)| *given) {
        return Err(key.field(field).refuse(format_args!("contradicts springs: {rule}")));
    }
    let source = key.field("particle");
    let refuse = |error| source.refuse(error);
    let cloud = ParticleCloud::new(particles(&source, &spec.particle)?).map_err(refuse)?;
    let stiffness_key = place.field("stiffness_n_per_m");
    let cloud = SpringCloud::new(&cloud, properties, read(&place, springs)?).map_err(|error| source.refuse(error))?;
    let [lowest, _] = cloud.natural_frequencies();
    let strain = (initial.angular_velocity.in_body().norm() / lowest).powi(2);
    // Written so that NaN is refused too.
    if strain <= MOST_STRAIN {
        return Ok(Some(Load { torque: general(cloud), window: Window::ALWAYS }));
    }
    let (stiffness, least) = (springs.stiffness_n_per_m, springs.stiffness_n_per_m * strain / MOST_STRAIN);
    let rule = format_args!("{stiffness:?} is too soft for this spin, which tears the body apart: {least:.4} or more");
    Err(stiffness_key.refuse(rule))
}

fn read(key: &Key, spec: &SpringsSpec) -> Result<Springs, Refusal> {
    let damping_key = key.field("damping_n_s_per_m");
    Ok(Springs {
        stiffness: positive(&key.field("stiffness_n_per_m"), spec.stiffness_n_per_m)?,
        damping: spec.damping_n_s_per_m.map_or(Ok(0.0), |damping| not_negative(&damping_key, damping))?,
        is_relaxed: spec.relaxed,
    })
}

fn general(cloud: SpringCloud) -> Torque {
    Torque::General(Arc::new(GeneralLoad::new(General::Cloud(cloud))))
}
