//! What makes a body turn: torques and forces, Euler's equations, the laws that motions obey.

mod problem;
mod torque;

pub use problem::Problem;
pub use torque::{Load, Torque, TorqueModel, Window};
