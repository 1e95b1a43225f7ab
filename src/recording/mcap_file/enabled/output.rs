use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use mcap::records::{MessageHeader, Metadata};
use mcap::write::NoSeek;
use mcap::{Attachment, Compression, McapError, WriteOptions, Writer};

use crate::recording::{PartFile, RecordingError};

/// The file: messages go in by topic, with their time.
pub(super) struct Output {
    writer: Writer<NoSeek<PartFile>>,
    path: PathBuf,
}

/// Where a kind of message goes.
#[derive(Debug)]
pub(super) struct Topic {
    channel: u16,
    sequence: u32,
}

impl Output {
    /// Uncompressed bytes after which a chunk is closed.
    const CHUNK: u64 = 1 << 20;

    /// Nothing here depends on the machine, the clock or the version of the crate: a chunk is compressed by one thread,
    /// and the file is a clean prefix of itself at any time, as nothing seeks back.
    pub fn create(file: PartFile) -> Result<Self, RecordingError> {
        let path = file.path().to_path_buf();
        let options = WriteOptions::new()
            .library("polhode")
            .profile("")
            .compression(Some(Compression::Zstd))
            .compression_level(1)
            .compression_threads(0)
            .chunk_size(Some(Self::CHUNK))
            .disable_seeking(true);
        let writer = options.create(NoSeek::new(file)).map_err(|error| refused(&path, error))?;
        Ok(Self { writer, path })
    }

    /// Puts a metadata record here.
    pub fn describe(&mut self, metadata: &Metadata) -> Result<(), RecordingError> {
        self.writer.write_metadata(metadata).map_err(|error| refused(&self.path, error))
    }

    /// Puts an attachment here.
    pub fn attach(&mut self, attachment: &Attachment) -> Result<(), RecordingError> {
        self.writer.attach(attachment).map_err(|error| refused(&self.path, error))
    }

    /// Registers a topic for protobuf messages of type `schema.0`, described by the `FileDescriptorSet` `schema.1`.
    pub fn topic(
        &mut self,
        name: &str,
        schema: (&str, &[u8]),
        metadata: &BTreeMap<String, String>,
    ) -> Result<Topic, RecordingError> {
        let channel = self
            .writer
            .add_schema(schema.0, "protobuf", schema.1)
            .and_then(|schema| self.writer.add_channel(schema, name, "protobuf", metadata))
            .map_err(|error| refused(&self.path, error))?;
        Ok(Topic { channel, sequence: 0 })
    }

    /// Adds a message at `stamp_ns` of simulated time.
    pub fn send(&mut self, topic: &mut Topic, stamp_ns: i64, message: &[u8]) -> Result<(), RecordingError> {
        let time = u64::try_from(stamp_ns).map_err(|_| RecordingError::NotRepresentable {
            path: self.path.clone(),
            rule: format!("a message at {stamp_ns} ns: no message is before the start"),
        })?;
        let header =
            MessageHeader { channel_id: topic.channel, sequence: topic.sequence, log_time: time, publish_time: time };
        topic.sequence = topic.sequence.wrapping_add(1);
        self.writer.write_to_known_channel(&header, message).map_err(|error| refused(&self.path, error))
    }

    /// Closes the chunk, so that what was sent can be read.
    pub fn flush(&mut self) -> Result<(), RecordingError> {
        self.writer.flush().map_err(|error| refused(&self.path, error))
    }

    /// Writes the indexes and hands back the file.
    pub fn finish(mut self) -> Result<PartFile, RecordingError> {
        self.writer.finish().map_err(|error| refused(&self.path, error))?;
        Ok(self.writer.into_inner().into_inner())
    }
}

impl fmt::Debug for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Output").field("path", &self.path).finish_non_exhaustive()
    }
}

fn refused(path: &std::path::Path, error: McapError) -> RecordingError {
    match error {
        McapError::Io(source) => RecordingError::Io { attempt: "write", path: path.into(), source },
        other => RecordingError::Encode { path: path.into(), reason: other.to_string() },
    }
}
