//! States at given times: closed forms and steppers behind one trait.

mod axial_torque;
mod ballistic;
mod cloud;
mod damped;
mod distance;
mod equations;
mod error;
mod exact;
mod fixed_step;
mod free;
mod general;
mod lagrange_top;
mod precise;
mod propagator;
mod runge_kutta;
mod sampling;
mod states;
mod taylor;

pub use axial_torque::AxialTorque;
pub use ballistic::Ballistic;
pub use damped::BrakedRotation;
pub use distance::{attitude_angle, attitude_distance, attitude_distances};
pub use error::PropagationError;
pub use fixed_step::{Coverage, FixedStep, FixedStepMethod, Information};
pub use free::{FreeRotation, Reversals};
pub use lagrange_top::LagrangeTop;
pub use precise::{PreciseState, PreciseTaylor};
pub use propagator::{Effort, Propagator};
pub use runge_kutta::Dop853;
pub use states::{CloudStates, ParticleColumns, States};
pub use taylor::Taylor;
