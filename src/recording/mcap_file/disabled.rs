use std::path::Path;

use crate::recording::foreign::{Mapping, Observation};
use crate::recording::recorded::Opened;
use crate::recording::{Contents, Interruption, PartFile, RecordingError, Sink, Subject};
use crate::telemetry::Samples;

/// The format that this build leaves out: there is no value of this type.
#[derive(Debug)]
pub enum McapFile {}

impl McapFile {
    /// Refuses.
    ///
    /// # Errors
    /// Always [`RecordingError::FormatAbsent`].
    #[expect(clippy::needless_pass_by_value, reason = "the same interface as with the feature")]
    pub fn create(_subject: &Subject, file: PartFile) -> Result<Self, RecordingError> {
        Err(absent(file.path()))
    }
}

impl Sink for McapFile {
    fn write(&mut self, _samples: &Samples) -> Result<(), RecordingError> {
        match *self {}
    }

    fn finish(self: Box<Self>) -> Result<PartFile, RecordingError> {
        match *self {}
    }

    fn interrupt(self: Box<Self>, _end: &Interruption) -> Result<PartFile, RecordingError> {
        match *self {}
    }
}

/// Refuses.
///
/// # Errors
/// Always [`RecordingError::FormatAbsent`].
pub fn contents(path: &Path) -> Result<Contents, RecordingError> {
    Err(absent(path))
}

/// Refuses.
///
/// # Errors
/// Always [`RecordingError::FormatAbsent`].
pub(in crate::recording) fn open(path: &Path) -> Result<Opened, RecordingError> {
    Err(absent(path))
}

/// Refuses.
///
/// # Errors
/// Always [`RecordingError::FormatAbsent`].
pub(in crate::recording) fn observe(path: &Path, _mapping: &Mapping) -> Result<Option<Observation>, RecordingError> {
    Err(absent(path))
}

fn absent(path: &Path) -> RecordingError {
    RecordingError::FormatAbsent { path: path.into(), feature: "mcap" }
}
