//! What a motion must show, measured on the motion itself: a check does not depend on how the run is sampled.

mod crossing;
mod drift;
mod outcome;
mod precession;
mod value;

pub use outcome::{CheckKind, CheckOutcome, CheckPlan};
