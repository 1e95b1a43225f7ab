use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use crate::recording::RecordingError;
use crate::recording::format::is_part;

/// Longest line that is taken for one, bytes: columns of a thousand bodies.
const LONGEST: u64 = 1 << 24;

/// Lines of a file, one at a time.
pub(in crate::recording) struct Lines {
    path: PathBuf,
    reader: BufReader<File>,
    line: String,
    number: u64,
    columns: usize,
    last_may_lack_its_end: bool,
}

impl Lines {
    pub fn open(path: &Path) -> Result<Self, RecordingError> {
        let file = File::open(path).map_err(|source| io_error(path, source))?;
        let reader = BufReader::with_capacity(1 << 16, file);
        let (line, number, columns, last_may_lack_its_end) = (String::new(), 0, 0, false);
        Ok(Self { path: path.into(), reader, line, number, columns, last_may_lack_its_end })
    }

    /// Lines of a program that may leave the last one without its end.
    pub fn open_foreign(path: &Path) -> Result<Self, RecordingError> {
        Ok(Self { last_may_lack_its_end: true, ..Self::open(path)? })
    }

    /// Goes to the next whole line; false at the end. What a `.part` has after its last whole line is left.
    pub fn advance(&mut self) -> Result<bool, RecordingError> {
        self.number += 1;
        let mut bytes = std::mem::take(&mut self.line).into_bytes();
        bytes.clear();
        let read = self.reader.by_ref().take(LONGEST).read_until(b'\n', &mut bytes);
        let read = read.map_err(|source| io_error(&self.path, source))? as u64;
        let mut is_whole = bytes.pop_if(|last| *last == b'\n').is_some();
        if !is_whole && read == LONGEST {
            return Err(self.wrong("has more than 16 MiB"));
        }
        is_whole |= self.last_may_lack_its_end && read > 0;
        if !is_whole && read > 0 && !self.is_part() {
            return Err(self.wrong("is cut off"));
        }
        bytes.pop_if(|last| *last == b'\r');
        if is_whole {
            self.line = String::from_utf8(bytes).map_err(|_| self.wrong("is not text (UTF-8)"))?;
        }
        if self.number == 1 {
            self.columns = self.line.split(',').count();
        }
        Ok(is_whole)
    }

    /// The line, without its end.
    pub fn text(&self) -> &str {
        &self.line
    }

    /// How many columns the first line has.
    pub fn columns(&self) -> usize {
        self.columns
    }

    pub fn is_part(&self) -> bool {
        is_part(&self.path)
    }

    /// A complaint about this line.
    pub fn wrong(&self, what: &str) -> RecordingError {
        self.refuse(format!("line {} {what}", self.number))
    }

    pub fn refuse(&self, reason: String) -> RecordingError {
        RecordingError::Decode { path: self.path.clone(), reason }
    }
}

fn io_error(path: &Path, source: std::io::Error) -> RecordingError {
    RecordingError::Io { attempt: "read", path: path.into(), source }
}
