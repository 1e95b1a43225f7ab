//! What makes a body turn: torques and forces, Euler's equations, the laws that motions obey.
//!
//! A [`Problem`] lists [`Load`]s as they were asked for. A [`Schedule`] is the same, ready to be integrated: cut where
//! windows open and close and where [`Profile`]s have knots, and in each [`Span`] everything that acts summed into one
//! [`Combined`]. Loads of kinds that do not add up so are [`General`]: operations on a tape, of which the rest can be made
//! too.

mod acceleration;
mod combined;
mod driven;
mod error;
mod euler;
pub mod formula;
mod general;
mod invariants;
mod kovalevskaya;
mod laws;
mod problem;
mod profile;
mod schedule;
mod spline;
mod torque;

pub use combined::{Combined, Couple, Gradient};
pub use driven::Driven;
pub use error::DynamicsError;
pub use euler::{EulerEquations, attitude_rate};
pub use general::{
    BDot, FormulaLoad, FormulaPlace, General, GeneralLoad, InnerSphere, Push, QuaternionFeedback, RateFeedback, Spring,
    Symbols,
};
pub use invariants::{jacobi_integral, momentum_in_world, potential_energy, rotational_energy, translational_energy};
pub use kovalevskaya::Kovalevskaya;
pub use laws::{EnergyLaw, MomentumLaw};
pub use problem::{Problem, rotor_momentum};
pub use profile::{Cubic, Interpolation, Profile};
pub use schedule::{Schedule, Span};
pub(crate) use torque::radial_direction;
pub use torque::{Load, Torque, TorqueModel, Window};
