//! What is watched of a motion, as columns: named channels with unit and frame, and the samples that carry them.
//!
//! A body's channels are made by a [`Derivation`]. A [`Point`] of it is recorded beside it, under a name of its own, and made
//! by a [`PointDerivation`] from the same states: probes and IMUs.

mod batch;
mod channel;
mod derive;
mod derive_point;
mod euler_angles;
mod figure;
mod figure_frame;
mod mounting;
mod point;
mod polhode;
mod samples;

pub use channel::{Channel, Row};
pub use derive::Derivation;
pub use derive_point::PointDerivation;
pub use euler_angles::EulerSequence;
pub use figure::FigureAxis;
pub use figure_frame::FigureFrame;
pub use mounting::Mounting;
pub use point::{Point, PointKind};
pub use polhode::{Encircled, separatrix_distance};
pub use samples::{BodySamples, Samples};
