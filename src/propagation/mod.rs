//! States at given times: closed forms and steppers behind one trait.

mod error;
mod propagator;
mod states;

pub use error::PropagationError;
pub use propagator::{Effort, Propagator};
pub use states::States;
