//! What a motion must show, measured on the motion itself: a check does not depend on how the run is sampled.

mod crossing;
mod drift;
mod extremum;
mod kind;
mod montgomery;
mod outcome;
mod particles;
mod period;
mod precession;
mod rate;
mod stability;
mod value;

pub use kind::CheckKind;
pub use outcome::{CheckOutcome, CheckPlan, Observation};
