//! Columns to `.mcap`, `.rrd` and `.csv`, whole or not at all.
//!
//! A [`Recorder`] gives each file its [`Sink`] by the file's extension; a [`PartFile`] gets its name only when all the
//! run's files are complete. [`contents`] tells what is in a recording, finished or not.

pub mod csv_file;
pub mod mcap_file;
pub mod picture;
pub mod rerun_file;

mod contents;
mod error;
mod format;
mod part_file;
mod recorder;
mod sink;

pub use contents::{Contents, Entry, contents};
pub use error::RecordingError;
pub use part_file::PartFile;
pub use recorder::{Finished, Recorder};
pub use sink::Sink;
