use nalgebra::Vector3;

use super::{AngularVelocity, Attitude};

/// Where a body is and how it moves at one instant.
///
/// Propagators use **principal** axes for "body": the plan turns the first state once, telemetry turns back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// World from body.
    pub attitude: Attitude,
    /// In body axes, rad/s.
    pub angular_velocity: AngularVelocity,
    /// Of the reference point, in world axes, m.
    pub position: Vector3<f64>,
    /// Of the reference point, in world axes, m/s.
    pub velocity: Vector3<f64>,
}
