use nalgebra::{Matrix3, Vector3};

use crate::body::Attitude;
use crate::numerics::so3::cross_product_matrix;

/// The motion of a rigid body at one instant, world axes: what the motion of each of its points follows from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidMotion {
    /// R: world from body.
    pub attitude: Attitude,
    /// X: where the reference point is, m. (Of a free body, the centre of mass.)
    pub position: Vector3<f64>,
    /// V = dX/dt, m/s.
    pub velocity: Vector3<f64>,
    /// A = dV/dt, m/s².
    pub acceleration: Vector3<f64>,
    /// ω, world axes, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// α = dω/dt, world axes, rad/s².
    pub angular_acceleration: Vector3<f64>,
}

impl RigidMotion {
    /// At rest in the world's origin, body axes along the world's.
    #[must_use]
    pub fn at_rest() -> Self {
        Self {
            attitude: Attitude::identity(),
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
            acceleration: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
        }
    }

    /// x = R p + X, m, for the point at `in_body` = p from the reference point, body axes, m.
    #[must_use]
    pub fn position_of(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.arm_of(in_body) + self.position
    }

    /// r = x − X = R p, m.
    #[must_use]
    pub fn arm_of(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.attitude.to_world(in_body)
    }

    /// v = ω × (x − X) + V, m/s.
    #[must_use]
    pub fn velocity_of(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.angular_velocity.cross(&self.arm_of(in_body)) + self.velocity
    }

    /// a = α × r + ω × (ω × r) + A, m/s²: turning faster, turning, and being carried along.
    #[must_use]
    pub fn acceleration_of(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        let arm = self.arm_of(in_body);
        let centripetal = self.angular_velocity.cross(&self.angular_velocity.cross(&arm));
        self.angular_acceleration.cross(&arm) + centripetal + self.acceleration
    }

    /// Ṙ = ω* R, 1/s: the rate of the matrix that takes body to world components.
    #[must_use]
    pub fn rotation_rate(&self) -> Matrix3<f64> {
        let rotation = self.attitude.world_from_body().to_rotation_matrix();
        cross_product_matrix(&self.angular_velocity) * rotation.matrix()
    }
}
