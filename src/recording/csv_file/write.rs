use std::io::{self, Write};

use super::header::header;
use crate::recording::{Interruption, PartFile, RecordingError, Sink, Subject};
use crate::telemetry::{BodySamples, Samples};

/// A `.csv` in the making.
#[derive(Debug)]
pub struct CsvFile {
    file: PartFile,
    text: Vec<u8>,
}

impl CsvFile {
    /// Starts with the line of column names.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn create(subject: &Subject, file: PartFile) -> Result<Self, RecordingError> {
        let mut text = header(&subject.heading.bodies).into_bytes();
        text.push(b'\n');
        let mut sink = Self { file, text };
        let written = sink.send();
        sink.check(written)?;
        Ok(sink)
    }

    /// `{:?}` of an f64 is its shortest form that reads back to the bit, with an exponent where it is very large or small.
    fn append(&mut self, samples: &Samples) -> io::Result<()> {
        for (index, time) in samples.times_s.iter().enumerate() {
            write!(self.text, "{time:?}")?;
            for column in samples.bodies.iter().flat_map(BodySamples::columns) {
                write!(self.text, ",{:?}", column[index])?;
            }
            self.text.push(b'\n');
        }
        self.send()
    }

    fn send(&mut self) -> io::Result<()> {
        let sent = self.file.write_all(&self.text);
        self.text.clear();
        sent
    }

    fn check(&self, written: io::Result<()>) -> Result<(), RecordingError> {
        written.map_err(|source| RecordingError::Io { attempt: "write", path: self.file.path().into(), source })
    }
}

impl Sink for CsvFile {
    fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        let written = self.append(samples).and_then(|()| self.file.flush_if_due());
        self.check(written)
    }

    fn finish(self: Box<Self>) -> Result<PartFile, RecordingError> {
        Ok(self.file)
    }

    fn interrupt(self: Box<Self>, _end: &Interruption) -> Result<PartFile, RecordingError> {
        Ok(self.file)
    }
}
