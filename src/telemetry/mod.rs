//! What is watched of a motion, as columns: named channels with unit and frame, and the samples that carry them.

mod channel;
mod samples;

pub use channel::{Channel, Row};
pub use samples::{BodySamples, Samples};
