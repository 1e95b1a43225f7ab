//! What a recording is of: all that its sink is told before the first sample, made from a plan or from what was read back.

mod digest;
mod facts;
mod sampling;
mod told;

pub use sampling::Sampling;
pub use told::Subject;

pub(super) use digest::sha256;
pub(super) use facts::{certificate, conventions, of_plan};
pub(super) use told::bodies;
