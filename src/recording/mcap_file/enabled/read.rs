use std::fs::File;
use std::io::{BufReader, Error};
use std::path::Path;

use mcap::McapError;

use super::scan::{Records, count};
use super::summary::read_summary;
use super::tally::Tally;
use crate::recording::format::is_part;
use crate::recording::{Contents, RecordingError};

/// Looks into an `.mcap`, whoever wrote it: from its summary if there is one, otherwise from end to end. A `.part` is
/// read from its start as far as it goes.
///
/// # Errors
/// If it cannot be read, is damaged, or is cut off and no `.part`. The data behind a sound summary is not checked.
pub fn contents(path: &Path) -> Result<Contents, RecordingError> {
    let io_error = |source: Error| RecordingError::Io { attempt: "read", path: path.into(), source };
    let file = File::open(path).map_err(io_error)?;
    let length = file.metadata().map_err(io_error)?.len();
    let mut file = BufReader::with_capacity(1 << 16, file);
    let is_part = is_part(path);
    if !is_part {
        let summary = read_summary(&mut file, length).map_err(|error| refused(path, error, "in the summary"))?;
        if let Some(tally) = summary {
            return Ok(tally.into_contents());
        }
    }
    let mut tally = Tally::default();
    let mut records = Records::begin(file).map_err(|error| refused(path, error, "at the start"))?;
    loop {
        match records.advance(|opcode, body| count(opcode, body, &mut tally)) {
            Ok(true) => {}
            Ok(false) => {
                tally.is_complete = true;
                return Ok(tally.into_contents());
            }
            Err(McapError::UnexpectedEof) if is_part => return Ok(tally.into_contents()),
            Err(error) => return Err(refused(path, error, &format!("before byte {}", records.bytes_read()))),
        }
    }
}

/// What is wrong with the file, and where.
pub(super) fn refused(path: &Path, error: McapError, place: &str) -> RecordingError {
    let reason = match error {
        McapError::Io(source) if source.get_ref().is_none() => {
            return RecordingError::Io { attempt: "read", path: path.into(), source };
        }
        McapError::Io(error) => error.to_string(),
        McapError::Parse(error) => format!("a record has another form than its kind: {}", error.root_cause()),
        other => other.to_string(),
    };
    RecordingError::Decode { path: path.into(), reason: format!("{reason}, {place}") }
}
