//! Scalar formulae as data, expanded in power series of time.
//!
//! A [`Tape`] lists operations, each on results before it. An [`Expansion`] works out the Taylor coefficients of every
//! result from those of the inputs, order by order `[GW08]`: the same list serves a value (order 0) and a series, in
//! f64 and in double-double ([`Scalar`]). Absolute values, maxima and minima are continuous and made of smooth branches:
//! an expansion stays on one branch of each, and tells where its series leaves it.

mod expansion;
mod list;
mod operation;
mod recurrence;
mod scalar;
mod sign;

pub use expansion::Expansion;
pub use list::Tape;
pub use operation::{Node, Operation};
pub use scalar::Scalar;
