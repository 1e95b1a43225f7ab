//! Columns to `.mcap`, `.rrd` and `.csv`, whole or not at all.
//!
//! A [`Recorder`] gives each file its [`Sink`] by the file's extension; a [`PartFile`] gets its name only when all the
//! run's files are complete. [`contents`] tells what is in a recording, finished or not;
//! a [`Recording`] reads its columns back, a [`Conversion`] writes them anew, [`recover`] makes a whole recording of what
//! a killed or interrupted run left. [`foreign::observe`] reads what any program recorded of bodies that turn. A [`LiveViewer`](live::LiveViewer) shows a run that goes on.

pub mod csv_file;
pub mod foreign;
pub mod live;
pub mod mcap_file;
pub mod picture;
pub mod rerun_file;

mod contents;
mod conversion;
mod error;
mod format;
mod interruption;
mod observed;
mod overlay;
mod part_file;
mod recorded;
mod recorder;
mod sink;
mod subject;
mod survey;

pub use contents::{Contents, Entry, contents};
pub(crate) use conversion::carried_scene;
pub use conversion::{Conversion, Recovered, recover};
pub use error::RecordingError;
pub use interruption::Interruption;
pub use observed::{Axes, Observed, Track};
pub use overlay::{DifferenceCurve, OverlaidBody, Overlay, Pose, Poses};
pub use part_file::PartFile;
pub use recorded::{Heading, RecordedBody, Recording};
pub use recorder::{Finished, Recorder};
pub use sink::Sink;
pub use subject::{Sampling, Subject};
pub use survey::{Range, Survey};
