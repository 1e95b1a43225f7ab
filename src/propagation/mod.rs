//! States at given times: closed forms and steppers behind one trait.

mod ballistic;
mod equations;
mod error;
mod fixed_step;
mod free;
mod propagator;
mod runge_kutta;
mod sampling;
mod states;
mod taylor;

pub use ballistic::Ballistic;
pub use error::PropagationError;
pub use fixed_step::{Coverage, FixedStep, FixedStepMethod, Information};
pub use free::FreeRotation;
pub use propagator::{Effort, Propagator};
pub use runge_kutta::Dop853;
pub use states::States;
pub use taylor::Taylor;
