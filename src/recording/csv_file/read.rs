use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use crate::recording::format::is_part;
use crate::recording::{Contents, Entry, RecordingError};

/// Longest line that is taken for one, bytes.
const LONGEST_LINE: u64 = 1 << 20;

/// Reads a `.csv` from end to end: its columns, how many lines they have, over which time.
///
/// # Errors
/// If it cannot be read, or a line has not one number for each column; if the last line is cut off, unless it is a
/// `.part`.
pub fn contents(path: &Path) -> Result<Contents, RecordingError> {
    let file = File::open(path).map_err(|source| io_error(path, source))?;
    let mut lines = Lines { path, reader: BufReader::with_capacity(1 << 16, file), line: String::new(), number: 0 };
    if !lines.advance()? {
        return Err(decode(path, "there is no first line, which names the columns".into()));
    }
    let columns: Vec<String> = lines.line.split(',').map(Into::into).collect();
    if columns[0] != "time_s" {
        return Err(decode(path, format!("the first column is {:?}, not \"time_s\"", columns[0])));
    }
    let (mut rows, mut from_s, mut to_s) = (0, None, None);
    while lines.advance()? {
        let time = lines.time_of_row(columns.len())?;
        from_s = from_s.or(Some(time));
        to_s = Some(time);
        rows += 1;
    }
    let entry = |name: String| Entry { name, kind: "column".into(), count: rows, from_s, to_s };
    Ok(Contents {
        format: "csv",
        details: vec![("rows".into(), rows.to_string()), ("columns".into(), columns.len().to_string())],
        entries: columns.into_iter().map(entry).collect(),
    })
}

/// Lines of a file, one at a time.
struct Lines<'path> {
    path: &'path Path,
    reader: BufReader<File>,
    line: String,
    number: u64,
}

impl Lines<'_> {
    /// Goes to the next whole line; false at the end.
    fn advance(&mut self) -> Result<bool, RecordingError> {
        self.number += 1;
        let mut bytes = std::mem::take(&mut self.line).into_bytes();
        bytes.clear();
        let read = self.reader.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut bytes);
        let read = read.map_err(|source| io_error(self.path, source))? as u64;
        let is_whole = bytes.pop_if(|last| *last == b'\n').is_some();
        if !is_whole && read > 0 && (read == LONGEST_LINE || !is_part(self.path)) {
            return Err(self.wrong("is cut off or has more than 1 MiB"));
        }
        bytes.pop_if(|last| *last == b'\r');
        self.line = String::from_utf8(bytes).map_err(|_| self.wrong("is not text (UTF-8)"))?;
        Ok(is_whole)
    }

    /// The first number of a line of `columns` numbers.
    fn time_of_row(&self, columns: usize) -> Result<f64, RecordingError> {
        let mut count = 0;
        let mut time = 0.0;
        for text in self.line.split(',') {
            let value: f64 = text.parse().map_err(|_| self.wrong(&format!("has {text:?} for a number")))?;
            if count == 0 {
                time = value;
            }
            count += 1;
        }
        if count == columns { Ok(time) } else { Err(self.wrong(&format!("has {count} values in {columns} columns"))) }
    }

    fn wrong(&self, what: &str) -> RecordingError {
        decode(self.path, format!("line {} {what}", self.number))
    }
}

fn decode(path: &Path, reason: String) -> RecordingError {
    RecordingError::Decode { path: path.into(), reason }
}

fn io_error(path: &Path, source: std::io::Error) -> RecordingError {
    RecordingError::Io { attempt: "read", path: path.into(), source }
}
