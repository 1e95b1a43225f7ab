//! What turns: mass properties, attitude, rates, state.
//!
//! Two frames: **world** (inertial) and **body** (fixed in the body, origin at its reference point: the centre of mass,
//! or the fixed pivot). Algorithms work in **principal** axes, the body axes turned so that the inertia tensor is
//! diagonal.
//!
//! [`MassProperties`] come from moments, a tensor, [`particles`], [`Solid`]s or a [`TriangleMesh`]; a [`Surface`] is
//! what a viewer draws of them.

pub mod particles;

mod assembly;
mod attitude;
mod error;
mod inertia;
mod mass_properties;
mod mesh;
#[cfg(feature = "serde")]
mod mesh_file;
mod principal_axes;
mod rates;
mod solids;
mod state;
mod surface;

pub use attitude::Attitude;
pub use error::BodyError;
pub use mass_properties::{MassProperties, PrincipalMoments};
pub use mesh::TriangleMesh;
pub use particles::{Particle, ParticleCloud};
pub use rates::{AngularMomentum, AngularVelocity, Moment};
pub use solids::{Shape, Solid, mass_properties_of};
pub use state::State;
pub use surface::Surface;
