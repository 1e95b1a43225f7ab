//! How far apart values may be, from words and from files.

mod error;
#[cfg(feature = "serde")]
mod file;
mod rule;
mod words;

pub use error::ToleranceError;
pub use rule::{Rule, Tolerance, Tolerances};
pub use words::channel_named;
pub(in crate::comparison) use words::unit;
