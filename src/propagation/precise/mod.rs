//! Taylor series in double-double: slow, with sixteen digits to spare, to measure the errors of everything else by.
//!
//! Independent of `taylor` as far as can be: loads are summed afresh in double-double, body images of world vectors come
//! from the rotation matrix of q and not from equations of their own, the gravity gradient's direction from its phase.
//! The parts: `acting` (constants of a span), `series` (coefficients), `state` (one instant), `propagator` (the
//! stepping), `choice` (this way, or by a tape).

mod acting;
mod choice;
mod drive;
mod propagator;
mod series;
mod state;

pub use choice::PreciseTaylor;
pub use state::PreciseState;
