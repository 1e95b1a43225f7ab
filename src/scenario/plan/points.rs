use std::collections::HashSet;

use nalgebra::Vector3;

use super::rules::{optional_vector, rotation, vector};
use crate::body::MassProperties;
use crate::scenario::{BodySpec, Frame, Key, Refusal};
use crate::telemetry::{Channel, Mounting, Point, PointKind};

const IN_WORLD: [Channel; 3] = [Channel::Position, Channel::Velocity, Channel::Acceleration];
const IN_BODY: [Channel; 3] = [Channel::PositionBody, Channel::VelocityBody, Channel::AccelerationBody];
const OF_IMU: [Channel; 2] = [Channel::Gyroscope, Channel::Accelerometer];

/// The probes of the body at `key`, called `body`, then its IMUs.
pub fn plan(key: &Key, spec: &BodySpec, body: &str, properties: &MassProperties) -> Result<Vec<Point>, Refusal> {
    let gravity = optional_vector(&key.field("gravity_m_s2"), spec.gravity_m_s2)?;
    let principal_from_body = properties.body_from_principal.inverse();
    let mut names = HashSet::new();
    let mut place = |key: &Key, name: &str, point: [f64; 3]| -> Result<(String, Mounting), Refusal> {
        let name_key = key.field("name");
        check_name(&name_key, name)?;
        if !names.insert(name.to_owned()) {
            return Err(name_key.refuse(format_args!("{name:?} is the name of two probes or IMUs of this body")));
        }
        let point: Vector3<f64> = vector(&key.field("point_m"), point)? - properties.about;
        let mounting = Mounting {
            arm: principal_from_body * point,
            principal_from_axes: principal_from_body,
            held_against: spec.pivot.is_some().then_some(gravity),
        };
        Ok((format!("{body}/{name}"), mounting))
    };
    let mut points = Vec::new();
    for (index, probe) in spec.probe.iter().enumerate() {
        let (name, mounting) = place(&key.field("probe").index(index), &probe.name, probe.point_m)?;
        let channels = match probe.frame {
            Frame::World => IN_WORLD,
            Frame::Body => IN_BODY,
        };
        points.push(Point { name, channels: channels.to_vec(), kind: PointKind::Mounted(mounting) });
    }
    for (index, imu) in spec.imu.iter().enumerate() {
        let key = key.field("imu").index(index);
        let (name, mut mounting) = place(&key, &imu.name, imu.point_m)?;
        let body_from_sensor = rotation(&key.field("attitude"), imu.attitude)?.world_from_body();
        mounting.principal_from_axes *= body_from_sensor;
        points.push(Point { name, channels: OF_IMU.to_vec(), kind: PointKind::Mounted(mounting) });
    }
    Ok(points)
}

fn check_name(key: &Key, name: &str) -> Result<(), Refusal> {
    let is_fit = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
    if (1..=64).contains(&name.len()) && name.chars().all(is_fit) {
        return Ok(());
    }
    Err(key.refuse(format_args!("{name:?}: 1 to 64 letters, digits, _ and -, as it names topics")))
}
