//! What turns: mass properties, attitude, rates, state.
//!
//! Two frames: **world** (inertial) and **body** (fixed in the body, origin at its reference point: the centre of mass,
//! or the fixed pivot). Algorithms work in **principal** axes, the body axes turned so that the inertia tensor is diagonal.

mod attitude;
mod error;
mod mass_properties;
mod rates;
mod state;

pub use attitude::Attitude;
pub use error::BodyError;
pub use mass_properties::{MassProperties, PrincipalMoments};
pub use rates::{AngularMomentum, AngularVelocity, Moment};
pub use state::State;
