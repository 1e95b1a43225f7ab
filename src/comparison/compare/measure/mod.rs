//! What is between two columns: the worst, the mean, bits, and how it grows.

mod bits;
mod channel;
pub(in crate::comparison) mod distance;
mod growth;
mod trace;

pub use bits::{Bits, Mark};
pub(in crate::comparison) use channel::Measure;
pub use channel::Worst;
pub use growth::{Growth, Law};
pub use trace::Trace;
