use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::PathBuf;

use mcap::Attachment;
use mcap::records::Metadata;

use super::chunk::Chunk;
use super::ending::Ending;
use super::record::{Kind, MAGIC, numbers, record, text, texts, with_length};
use crate::recording::{PartFile, RecordingError};

/// The file: messages go in by topic, with their time.
///
/// Nothing here depends on the machine, the clock or the number of threads, and the file is a clean prefix of itself at
/// any time, as nothing seeks back.
pub(in super::super) struct Output {
    /// `None` once it was handed back.
    file: Option<PartFile>,
    path: PathBuf,
    position: u64,
    checksum: crc32fast::Hasher,
    chunk: Chunk,
    schemas: Vec<String>,
    ending: Ending,
    buffer: Vec<u8>,
}

/// Where a kind of message goes.
#[derive(Debug)]
pub(in super::super) struct Topic {
    channel: u16,
    sequence: u32,
}

impl Output {
    /// Begins the file.
    pub fn create(file: PartFile) -> Result<Self, RecordingError> {
        let path = file.path().to_path_buf();
        let mut output = Self {
            chunk: Chunk::new().map_err(|error| refused(&path, &error))?,
            file: Some(file),
            path,
            position: 0,
            checksum: crc32fast::Hasher::new(),
            schemas: Vec::new(),
            ending: Ending::default(),
            buffer: MAGIC.to_vec(),
        };
        record(&mut output.buffer, Kind::Header, |bytes| {
            text(bytes, "");
            text(bytes, "polhode");
        });
        output.send_buffer()?;
        Ok(output)
    }

    /// Puts a metadata record here.
    pub fn describe(&mut self, metadata: &Metadata) -> Result<(), RecordingError> {
        self.close_chunk()?;
        record(&mut self.buffer, Kind::Metadata, |bytes| {
            text(bytes, &metadata.name);
            texts(bytes, &metadata.metadata);
        });
        let place = [self.position, self.buffer.len() as u64];
        self.ending.metadata_indexes.add(Kind::MetadataIndex, |bytes| {
            numbers(bytes, place);
            text(bytes, &metadata.name);
        });
        self.send_buffer()
    }

    /// Puts an attachment here.
    pub fn attach(&mut self, attachment: &Attachment) -> Result<(), RecordingError> {
        self.close_chunk()?;
        let times = [attachment.log_time, attachment.create_time];
        record(&mut self.buffer, Kind::Attachment, |bytes| {
            let start = bytes.len();
            numbers(bytes, times);
            text(bytes, &attachment.name);
            text(bytes, &attachment.media_type);
            with_length::<u64>(bytes, |bytes| bytes.extend_from_slice(&attachment.data));
            bytes.extend_from_slice(&crc32fast::hash(&bytes[start..]).to_le_bytes());
        });
        let place = [self.position, self.buffer.len() as u64];
        self.ending.attachment_indexes.add(Kind::AttachmentIndex, |bytes| {
            numbers(bytes, place);
            numbers(bytes, times);
            numbers(bytes, [attachment.data.len() as u64]);
            text(bytes, &attachment.name);
            text(bytes, &attachment.media_type);
        });
        self.send_buffer()
    }

    /// Registers a topic for protobuf messages of type `schema.0`, described by the `FileDescriptorSet` `schema.1`.
    pub fn topic(
        &mut self,
        name: &str,
        schema: (&str, &[u8]),
        metadata: &BTreeMap<String, String>,
    ) -> Result<Topic, RecordingError> {
        let schema = self.schema(schema)?;
        self.ending.messages.push(0);
        let channel = self.number(self.ending.messages.len())?;
        let start = self.chunk.records().len();
        record(self.chunk.records(), Kind::Channel, |bytes| {
            bytes.extend_from_slice(&channel.to_le_bytes());
            bytes.extend_from_slice(&schema.to_le_bytes());
            text(bytes, name);
            text(bytes, "protobuf");
            texts(bytes, metadata);
        });
        self.ending.channels.repeat(&self.chunk.records()[start..]);
        Ok(Topic { channel, sequence: 0 })
    }

    /// Number of the schema of that name, which is written where it is new.
    fn schema(&mut self, (name, descriptor): (&str, &[u8])) -> Result<u16, RecordingError> {
        if let Some(known) = self.schemas.iter().position(|known| known == name) {
            return self.number(known + 1);
        }
        self.schemas.push(name.into());
        let number = self.number(self.schemas.len())?;
        let start = self.chunk.records().len();
        record(self.chunk.records(), Kind::Schema, |bytes| {
            bytes.extend_from_slice(&number.to_le_bytes());
            text(bytes, name);
            text(bytes, "protobuf");
            with_length::<u32>(bytes, |bytes| bytes.extend_from_slice(descriptor));
        });
        self.ending.schemas.repeat(&self.chunk.records()[start..]);
        Ok(number)
    }

    /// Schemas and channels are numbered from 1, in 16 bits.
    fn number(&self, count: usize) -> Result<u16, RecordingError> {
        u16::try_from(count).map_err(|_| RecordingError::NotRepresentable {
            path: self.path.clone(),
            rule: format!("{count} topics: an .mcap has 65535 at most"),
        })
    }

    /// Adds a message at `stamp_ns` of simulated time; `data` appends its content.
    pub fn send(
        &mut self,
        topic: &mut Topic,
        stamp_ns: i64,
        data: impl FnOnce(&mut Vec<u8>),
    ) -> Result<(), RecordingError> {
        let time = u64::try_from(stamp_ns).map_err(|_| RecordingError::NotRepresentable {
            path: self.path.clone(),
            rule: format!("a message at {stamp_ns} ns: no message is before the start"),
        })?;
        if self.chunk.is_full() {
            self.close_chunk()?;
        }
        self.chunk.message((topic.channel, topic.sequence), time, data);
        topic.sequence = topic.sequence.wrapping_add(1);
        Ok(())
    }

    /// Closes the chunk, so that what was sent can be read.
    pub fn flush(&mut self) -> Result<(), RecordingError> {
        self.close_chunk()?;
        let flushed = self.file.as_mut().map_or(Ok(()), Write::flush);
        flushed.map_err(|source| self.unwritten(source))
    }

    /// Flushes closed chunks from time to time. The open one stays open: where chunks end is no matter of the clock.
    pub fn flush_if_due(&mut self) -> Result<(), RecordingError> {
        let flushed = self.file.as_mut().map_or(Ok(()), PartFile::flush_if_due);
        flushed.map_err(|source| self.unwritten(source))
    }

    /// Writes the indexes and hands back the file.
    pub fn finish(mut self) -> Result<PartFile, RecordingError> {
        self.close_chunk()?;
        self.ending.write(&mut self.buffer, self.position, self.checksum.clone().finalize());
        self.send_buffer()?;
        self.file.take().ok_or_else(|| self.unwritten(io::ErrorKind::BrokenPipe.into()))
    }

    fn close_chunk(&mut self) -> Result<(), RecordingError> {
        let closed = self.chunk.close(&mut self.buffer, self.position, &mut self.ending);
        if closed.map_err(|error| refused(&self.path, &error))? {
            self.send_buffer()?;
        }
        Ok(())
    }

    /// Hands the buffer to the file and empties it.
    fn send_buffer(&mut self) -> Result<(), RecordingError> {
        let written = self.file.as_mut().map_or(Ok(()), |file| file.write_all(&self.buffer));
        written.map_err(|source| self.unwritten(source))?;
        self.checksum.update(&self.buffer);
        self.position += self.buffer.len() as u64;
        self.buffer.clear();
        Ok(())
    }

    fn unwritten(&self, source: io::Error) -> RecordingError {
        RecordingError::Io { attempt: "write", path: self.path.clone(), source }
    }
}

impl Drop for Output {
    /// A run that is given up leaves what it has.
    fn drop(&mut self) {
        if self.file.is_some() {
            // Nobody is left to tell, and after a failure nothing is written.
            let _ = self.close_chunk();
        }
    }
}

impl std::fmt::Debug for Output {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Output").field("path", &self.path).finish_non_exhaustive()
    }
}

fn refused(path: &std::path::Path, error: &io::Error) -> RecordingError {
    RecordingError::Encode { path: path.into(), reason: error.to_string() }
}
