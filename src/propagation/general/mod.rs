//! Motion under loads of any kind: everything that acts is one tape, whose Taylor series is worked out by recurrence.
//!
//! The parts: `equations` (the tape of a span), `motion` (a state, and its series over one step), `step` (how far a series
//! reaches), `stepper` (from step to step), `propagator` (in f64) and `precise` (in double-double). Slower than `taylor`, whose recurrences are laid out
//! by hand, and so used only where a load has none there.

mod equations;
mod motion;
mod precise;
mod propagator;
mod step;
mod stepper;

pub(super) use precise::PreciseGeneral;
pub(super) use propagator::GeneralTaylor;
pub(super) use step::{LONGEST_STEP, power_of_two};
