use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use mcap::McapError;

use super::intake::Intake;
use super::read::refused;
use super::scan::Records;
use crate::recording::RecordingError;
use crate::recording::format::is_part;
use crate::recording::recorded::{Opened, Source};
use crate::telemetry::Samples;

/// The samples of an `.mcap`, from its start.
struct McapSource {
    path: PathBuf,
    records: Records<BufReader<File>>,
    intake: Intake,
    end: Option<End>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    Whole,
    BrokenOff,
}

/// Reads up to the first sample: everything that comes before it is the heading.
///
/// # Errors
/// If it cannot be read, is damaged, or no recording of this crate.
pub(in crate::recording) fn open(path: &Path) -> Result<Opened, RecordingError> {
    let io_error = |source| RecordingError::Io { attempt: "read", path: path.into(), source };
    let file = BufReader::with_capacity(1 << 16, File::open(path).map_err(io_error)?);
    let records = Records::begin(file).map_err(|error| refused(path, error, "at the start"))?;
    let mut source = McapSource { path: path.into(), records, intake: Intake::default(), end: None };
    while source.intake.is_empty() && source.advance()? {}
    if source.intake.heading().bodies.is_empty() {
        let reason = "it has no topic of polhode.BodyState: no recording of this program, or none of its start".into();
        return Err(RecordingError::Decode { path: path.into(), reason });
    }
    Ok((source.intake.heading().clone(), Box::new(source)))
}

impl McapSource {
    /// Goes on by one step; false at the end, wherever a `.part` has it.
    fn advance(&mut self) -> Result<bool, RecordingError> {
        if self.end.is_some() {
            return Ok(false);
        }
        let intake = &mut self.intake;
        match self.records.advance(|opcode, body| intake.take(opcode, body)) {
            Ok(true) => return Ok(true),
            Ok(false) => self.end = Some(End::Whole),
            Err(McapError::UnexpectedEof) if is_part(&self.path) => self.end = Some(End::BrokenOff),
            Err(error) => {
                let place = format!("before byte {}", self.records.bytes_read());
                return Err(refused(&self.path, error, &place));
            }
        }
        Ok(false)
    }
}

impl Source for McapSource {
    fn fill(&mut self, most: usize, samples: &mut Samples) -> Result<(), RecordingError> {
        while self.intake.whole_samples() < most && self.advance()? {}
        if self.end == Some(End::Whole) && !self.intake.is_between_samples() {
            let reason = "the last sample lacks a body".into();
            return Err(RecordingError::Decode { path: self.path.clone(), reason });
        }
        self.intake.hand_over(samples);
        Ok(())
    }

    fn is_whole(&self) -> bool {
        self.end == Some(End::Whole)
    }
}
