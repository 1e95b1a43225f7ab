use std::ffi::OsStr;
use std::path::Path;

use super::RecordingError;

/// What a recording's extension stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Mcap,
    Rrd,
    Csv,
}

impl Format {
    /// By extension, in small letters.
    pub fn of(path: &Path) -> Result<Self, RecordingError> {
        match path.extension().and_then(OsStr::to_str) {
            Some("mcap") => Ok(Self::Mcap),
            Some("rrd") => Ok(Self::Rrd),
            Some("csv") => Ok(Self::Csv),
            _ => Err(RecordingError::UnknownFormat { path: path.into() }),
        }
    }
}

/// Whether this is what a run in progress, or a killed one, calls its file: its end may be missing.
pub(super) fn is_part(path: &Path) -> bool {
    path.extension() == Some(OsStr::new("part"))
}
