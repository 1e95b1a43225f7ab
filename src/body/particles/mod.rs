//! Point masses, and the laws of a rigid body derived from them.
//!
//! A rigid body is a set of particles at fixed positions pᵢ in body axes. All else follows, in world axes
//! (`[Baraff97]`, `[Goldstein02]` ch. 4 and 5):
//!
//! | law | here |
//! |---|---|
//! | xᵢ = R pᵢ + X | [`RigidMotion::position_of`] |
//! | Ṙ = ω* R | [`RigidMotion::rotation_rate`] |
//! | vᵢ = ω × (xᵢ − X) + V | [`RigidMotion::velocity_of`] |
//! | aᵢ = α × r + ω × (ω × r) + A | [`RigidMotion::acceleration_of`] |
//! | X = Σ mᵢ xᵢ / M, I₀ = Σ mᵢ (r² E − r rᵀ) | [`ParticleCloud::mass_properties`] |
//! | F = Σ Fᵢ = M A | [`total_force`], [`acceleration_of_centre`] |
//! | τᵢ = (xᵢ − X) × Fᵢ, T = Σ τᵢ | [`PointForce::moment_about`], [`total_moment`] |
//! | internal forces: F = 0, T = 0 | [`internal_resultant`] |
//! | I(t) = R I₀ Rᵀ | [`tensor_in_world`] |
//! | L = I(t) ω = Σ mᵢ rᵢ × vᵢ | [`angular_momentum`], [`ParticleCloud::angular_momentum`] |
//! | dL/dt = T, so α = I⁻¹ (T − ω × L) | [`angular_acceleration`] |
//!
//! These are the definitions, in plain vectors: what fast paths are checked against and what a viewer's points need.

mod cloud;
mod forces;
mod momentum;
mod motion;
mod springs;

pub use cloud::{Particle, ParticleCloud};
pub use forces::{PointForce, acceleration_of_centre, total_force, total_moment};
pub use momentum::{angular_acceleration, angular_momentum, tensor_in_world};
pub use motion::RigidMotion;
pub use springs::{Resultant, Spring, internal_resultant, spring_forces};
