//! Are two recordings the same motion? Is one of them true?
//!
//! [`Comparison`] pairs the samples of two [`Side`]s by time, recordings or scenes, and says in a [`Report`] how far they
//! are apart, where, since when, and by which law that grows. [`verify`] holds what one recording says, of whatever
//! program, against physics.

pub mod verify;

mod compare;

pub use compare::{
    Bits, BodyReport, ChannelReport, CompareError, Comparison, Coverage, Difference, FactDifference, Growth, Law, Mark,
    Report, Rule, Side, SideReport, Tolerance, ToleranceError, Tolerances, Trace, Worst,
};
