use nalgebra::{Matrix3, Vector3};

use super::{Particle, ParticleCloud, RigidMotion};
use crate::body::{Attitude, MassProperties};

/// I(t) = R I₀ Rᵀ, world axes, kg m², from I₀ in body axes.
#[must_use]
pub fn tensor_in_world(attitude: Attitude, tensor_in_body: &Matrix3<f64>) -> Matrix3<f64> {
    let rotation = attitude.world_from_body().to_rotation_matrix();
    rotation * tensor_in_body * rotation.inverse()
}

/// L = I(t) ω, N m s, all in world axes.
#[must_use]
pub fn angular_momentum(tensor_in_world: &Matrix3<f64>, angular_velocity: &Vector3<f64>) -> Vector3<f64> {
    tensor_in_world * angular_velocity
}

/// α = I(t)⁻¹ (T − ω × I(t) ω), rad/s²: what dL/dt = T says of ω. All in world axes, about the point of `body.moments`.
#[must_use]
pub fn angular_acceleration(
    body: &MassProperties,
    attitude: Attitude,
    angular_velocity: &Vector3<f64>,
    moment: &Vector3<f64>,
) -> Vector3<f64> {
    let world_from_principal = attitude.world_from_body() * body.body_from_principal;
    let omega = world_from_principal.inverse_transform_vector(angular_velocity);
    let moment = world_from_principal.inverse_transform_vector(moment);
    let moments = body.moments.vector();
    let gyroscopic = omega.cross(&moments.component_mul(&omega));
    world_from_principal * (moment - gyroscopic).component_div(&moments)
}

impl ParticleCloud {
    /// P = Σ mᵢ vᵢ, N s, world axes, where `motion` is that of the point at `reference` (from the body's origin, body
    /// axes, m). About the centre of mass it is M V.
    #[must_use]
    pub fn momentum(&self, motion: &RigidMotion, reference: &Vector3<f64>) -> Vector3<f64> {
        let term = |&Particle { mass, position }: &Particle| motion.velocity_of(&(position - reference)) * mass;
        self.particles().iter().map(term).sum()
    }

    /// L = Σ mᵢ rᵢ × vᵢ about the point at `reference`, whose motion is `motion`, N m s, world axes.
    ///
    /// Velocities are relative to that point, so that about the centre of mass, or about a fixed pivot, L = I(t) ω.
    #[must_use]
    pub fn angular_momentum(&self, motion: &RigidMotion, reference: &Vector3<f64>) -> Vector3<f64> {
        let term = |&Particle { mass, position }: &Particle| {
            let in_body = position - reference;
            let velocity = motion.velocity_of(&in_body) - motion.velocity;
            motion.arm_of(&in_body).cross(&velocity) * mass
        };
        self.particles().iter().map(term).sum()
    }
}
