//! What is watched of a motion, as columns: named channels with unit and frame, and the samples that carry them.

mod channel;
mod derive;
mod figure;
mod samples;

pub use channel::{Channel, Row};
pub use derive::Derivation;
pub use figure::FigureAxis;
pub use samples::{BodySamples, Samples};
