//! What a recording is of: all that its sink is told before the first sample, made from a plan or from what was read back.

mod digest;
mod facts;
mod sampling;
mod told;

pub use sampling::Sampling;
pub use told::Subject;

pub(super) use digest::sha256;
#[cfg(any(feature = "mcap", feature = "rerun"))]
pub(super) use facts::certificate;
pub(super) use facts::{CHECK, conventions, of_plan};
#[cfg(feature = "rerun")]
pub(super) use told::bodies;
