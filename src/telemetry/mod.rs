//! What is watched of a motion, as columns: named channels with unit and frame, and the samples that carry them.

mod channel;
mod derive;
mod euler_angles;
mod figure;
mod figure_frame;
mod polhode;
mod samples;

pub use channel::{Channel, Row};
pub use derive::Derivation;
pub use euler_angles::EulerSequence;
pub use figure::FigureAxis;
pub use figure_frame::FigureFrame;
pub use polhode::{Encircled, separatrix_distance};
pub use samples::{BodySamples, Samples};
