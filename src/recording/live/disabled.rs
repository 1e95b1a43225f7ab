use crate::recording::{RecordingError, Subject};
use crate::telemetry::Samples;

/// What this build leaves out: there is no value of this type.
#[derive(Debug)]
pub enum LiveViewer {}

impl LiveViewer {
    /// Refuses.
    ///
    /// # Errors
    /// Always [`RecordingError::FormatAbsent`].
    pub fn connect(_subject: &Subject, address: &str) -> Result<Self, RecordingError> {
        Err(RecordingError::FormatAbsent { path: address.into(), feature: "live" })
    }

    /// There is nothing to write to.
    ///
    /// # Errors
    /// None.
    pub fn write(&mut self, _samples: &Samples) -> Result<(), RecordingError> {
        match *self {}
    }

    /// There is nothing to finish.
    ///
    /// # Errors
    /// None.
    pub fn finish(self) -> Result<(), RecordingError> {
        match self {}
    }
}
