//! Recordings of whatever program, as what they say of bodies that turn.
//!
//! [`observe`] reads a recording of this crate, an `.mcap` of transforms, poses, IMUs and twists (Foxglove's schemas or
//! ROS 2), an `.rrd` of transforms, or a table of numbers as text, and gives one [`Observed`](super::Observed) for each
//! body. A [`Mapping`] says what a file cannot say of itself: which column is what, in which unit and order.

pub(super) mod attitudes;
mod clock;
#[cfg(feature = "serde")]
mod from_text;
#[cfg(any(feature = "mcap", feature = "rerun"))]
pub(super) mod gathering;
mod mapping;
mod observe;
mod own;
pub(super) mod table;

pub use mapping::{AngleUnit, BodyMapping, Mapping, RateUnit, Sense, Separator, TimeUnit};
pub use observe::{Observation, observe};
