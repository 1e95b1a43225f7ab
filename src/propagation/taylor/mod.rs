//! Taylor series of high order: the working method for motions under torque.
//!
//! In (q, ω, body images of world vectors) the equations of motion are bilinear, so that each Taylor coefficient is a
//! convolution of those before it. The parts, each usable without the next: `series` and `recurrence` (coefficients, for
//! any way of stepping), `drive` (what changes with time), `step_size`, `dense` (evaluation), `carried` (compensated state),
//! `propagator` (the stepping), `choice` (this way, or by a tape).

mod carried;
mod choice;
mod dense;
mod drive;
mod products;
mod propagator;
mod recurrence;
mod row;
mod series;
mod step_size;
mod stretch;
mod sums;
mod terms;
mod translation;

pub use choice::Taylor;
