use std::fs::File;
use std::io::{BufReader, Read as _};
use std::path::{Path, PathBuf};

use re_log_encoding::{
    CachingApplicationIdInjector, Decodable as _, Encodable as _, MessageHeader, MessageKind, StreamFooter,
    StreamHeader,
};
use re_log_types::LogMsg;
use re_protos::log_msg::v1alpha1::log_msg::Msg;
use re_protos::log_msg::v1alpha1::{ArrowMsg, BlueprintActivationCommand, SetStoreInfo};

use super::unpack;
use crate::recording::RecordingError;
use crate::recording::format::is_part;

/// The messages of an `.rrd`, one at a time.
///
/// Rerun's own iterator takes a cut-off file for a whole one and believes every length it reads; here a length is held
/// against the file's, and a file under its final name must end with its footer.
pub(super) struct Messages {
    reader: BufReader<File>,
    path: PathBuf,
    version: re_build_info::CrateVersion,
    position: u64,
    length: u64,
    ids: CachingApplicationIdInjector,
    end: End,
}

/// How far a file was read, and how it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// There may be more.
    NotYet,
    /// The footer came.
    Whole,
    /// The file of an unfinished run: it broke off.
    BrokenOff,
    /// Something was wrong.
    Failed,
}

impl Messages {
    /// Opens a file and reads its header.
    ///
    /// # Errors
    /// If it cannot be read, or is no `.rrd` that this version understands.
    pub(super) fn open(path: &Path) -> Result<Self, RecordingError> {
        let io_error = |source| RecordingError::Io { attempt: "read", path: path.into(), source };
        let file = File::open(path).map_err(io_error)?;
        let length = file.metadata().map_err(io_error)?.len();
        let mut messages = Self {
            reader: BufReader::with_capacity(1 << 16, file),
            path: path.into(),
            version: re_build_info::CrateVersion::LOCAL,
            position: 0,
            length,
            ids: CachingApplicationIdInjector::default(),
            end: End::NotYet,
        };
        let Some(header) = messages.bytes(StreamHeader::ENCODED_SIZE_BYTES as u64)? else {
            return Err(messages.damaged("shorter than its header"));
        };
        messages.version = StreamHeader::from_rrd_bytes(&header)
            .and_then(StreamHeader::to_version_and_options)
            .map_err(|error| messages.damaged(error))?
            .0;
        Ok(messages)
    }

    /// The version of Rerun that the file was written with.
    pub(super) fn version(&self) -> re_build_info::CrateVersion {
        self.version
    }

    /// How the file ended, once there are no more messages.
    pub(super) fn end(&self) -> End {
        self.end
    }

    /// A complaint with the file's name and place.
    pub(super) fn damaged(&self, reason: impl std::fmt::Display) -> RecordingError {
        let reason = format!("{reason} (before byte {})", self.position);
        RecordingError::Decode { path: self.path.clone(), reason }
    }

    fn read(&mut self) -> Result<Option<LogMsg>, RecordingError> {
        let Some(header) = self.bytes(MessageHeader::ENCODED_SIZE_BYTES as u64)? else { return self.broken_off() };
        let header = MessageHeader::from_rrd_bytes(&header).map_err(|error| self.damaged(error))?;
        let start = self.position;
        let Some(payload) = self.bytes(header.len)? else { return self.broken_off() };
        let message = match header.kind {
            MessageKind::End => return self.read_footer(start, &payload),
            MessageKind::SetStoreInfo => SetStoreInfo::from_rrd_bytes(&payload).map(Msg::SetStoreInfo),
            MessageKind::ArrowMsg => ArrowMsg::from_rrd_bytes(&payload).map(Msg::ArrowMsg),
            MessageKind::BlueprintActivationCommand => {
                BlueprintActivationCommand::from_rrd_bytes(&payload).map(Msg::BlueprintActivationCommand)
            }
        };
        let message = message.map_err(|error| self.damaged(error))?;
        let message = unpack::message(message, &mut self.ids, self.version).map_err(|reason| self.damaged(reason))?;
        Ok(Some(message))
    }

    /// The footer's footer holds place, length and check sum of the footer: as they should be, or damage.
    fn read_footer(&mut self, start: u64, payload: &[u8]) -> Result<Option<LogMsg>, RecordingError> {
        let Some(found) = self.bytes(StreamFooter::ENCODED_SIZE_BYTES as u64)? else { return self.broken_off() };
        let mut expected = Vec::with_capacity(found.len());
        StreamFooter::from_rrd_footer_bytes(start, payload)
            .to_rrd_bytes(&mut expected)
            .map_err(|error| self.damaged(error))?;
        if found != expected {
            return Err(self.damaged("the footer's check sum is wrong"));
        }
        if self.position != self.length {
            return Err(self.damaged(format!("{} bytes after the end", self.length - self.position)));
        }
        self.end = End::Whole;
        Ok(None)
    }

    /// The file ends within a message. Unfinished ones may.
    fn broken_off(&mut self) -> Result<Option<LogMsg>, RecordingError> {
        if !is_part(&self.path) {
            return Err(self.damaged("cut off: the footer is missing"));
        }
        self.end = End::BrokenOff;
        Ok(None)
    }

    /// The next `count` bytes, or `None` if the file has fewer.
    fn bytes(&mut self, count: u64) -> Result<Option<Vec<u8>>, RecordingError> {
        if count > self.length.saturating_sub(self.position) {
            return Ok(None);
        }
        let mut bytes = Vec::new();
        let read = self.reader.by_ref().take(count).read_to_end(&mut bytes).map_err(|source| RecordingError::Io {
            attempt: "read",
            path: self.path.clone(),
            source,
        })?;
        self.position += read as u64;
        Ok((read as u64 == count).then_some(bytes))
    }
}

impl Iterator for Messages {
    type Item = Result<LogMsg, RecordingError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.end != End::NotYet {
            return None;
        }
        let message = self.read();
        if message.is_err() {
            self.end = End::Failed;
        }
        message.transpose()
    }
}
