//! Columns to `.mcap`, `.rrd` and `.csv`, whole or not at all.

mod error;
pub mod picture;
mod sink;

pub use error::RecordingError;
pub use sink::Sink;
