//! Point masses, and the laws of a rigid body derived from them.

mod cloud;

pub use cloud::{Particle, ParticleCloud};
