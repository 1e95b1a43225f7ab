//! Are two recordings the same motion? Is one of them true?
//!
//! [`Comparison`] pairs the samples of two [`Side`]s by time, recordings or scenes, and says in a [`Report`] how far they
//! are apart, where, since when, and by which law that grows. `digest` (with one of the features `mcap` and `rerun`) is
//! the SHA-256 of a recording's content, whatever its format. [`verify`] holds what one recording says, of whatever
//! program, against physics.

pub mod verify;

mod compare;
#[cfg(any(feature = "mcap", feature = "rerun"))]
mod digest;

pub use compare::{
    Bits, BodyReport, ChannelReport, CompareError, Comparison, Coverage, Difference, EventDifference, FactDifference,
    Finding, Growth, Law, Mark, Report, Rule, Shapes, Side, SideReport, Tolerance, ToleranceError, Tolerances, Trace,
    Worst, channel_named,
};
#[cfg(any(feature = "mcap", feature = "rerun"))]
pub use digest::{Digest, digest};
