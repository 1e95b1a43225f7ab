//! Which stepper keeps an attitude error over a whole run, and how loosely it may step: found by trial runs.

mod keep;
mod nudge;
mod search;
mod trials;

pub use keep::{Kept, keep};
pub use nudge::nudged;
pub use search::Stepper;
