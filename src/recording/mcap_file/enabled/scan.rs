use std::io::{Error, Read, Seek};

use mcap::records::{Record, op};
use mcap::sans_io::linear_reader::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{McapError, McapResult};

use super::parse::parse;
use super::tally::Tally;
use super::unpack::Unpacked;

/// No record is longer, and no chunk, packed or unpacked: what a damaged length asks for is not allocated.
const LONGEST_RECORD: usize = 1 << 28;

/// No more room is made at once than a chunk of this crate's takes: a length that is only claimed costs as much as is there.
const LONGEST_READ: usize = 1 << 20;

/// The records of a file from its start, those in chunks among them. A chunk's come only after its checksum was found
/// right.
pub(super) struct Records<R> {
    file: R,
    reader: LinearReader,
    chunk: Unpacked,
    bytes_read: u64,
    data_has_ended: bool,
}

impl<R: Read + Seek> Records<R> {
    pub fn begin(mut file: R) -> McapResult<Self> {
        file.rewind()?;
        let options = LinearReaderOptions::default()
            .with_emit_chunks(true)
            .with_validate_data_section_crc(true)
            .with_validate_summary_section_crc(true)
            .with_record_length_limit(LONGEST_RECORD);
        let reader = LinearReader::new_with_options(options);
        Ok(Self { file, reader, chunk: Unpacked::default(), bytes_read: 0, data_has_ended: false })
    }

    /// Goes on by one step, which may bring a record: kind and fields. False at the end.
    pub fn advance(&mut self, visit: impl FnOnce(u8, &[u8]) -> McapResult<()>) -> McapResult<bool> {
        if let Some((opcode, body)) = self.chunk.advance()? {
            visit(opcode, body)?;
            return Ok(true);
        }
        match self.reader.next_event().transpose()? {
            None => return Ok(false),
            Some(LinearReadEvent::ReadRequest(bytes)) => {
                let read = self.file.read(self.reader.insert(bytes.min(LONGEST_READ)))?;
                self.bytes_read += read as u64;
                self.reader.notify_read(read);
            }
            Some(LinearReadEvent::Record { data, opcode: op::CHUNK }) => {
                self.chunk.unpack(data, LONGEST_RECORD as u64)?;
            }
            Some(LinearReadEvent::Record { data, opcode }) => {
                self.data_has_ended |= opcode == op::DATA_END;
                // Readers pass over records of kinds unknown to them, and without this one nothing is held to its checksum.
                if opcode == op::FOOTER && !self.data_has_ended {
                    return Err(McapError::Io(Error::other("its data has no end")));
                }
                visit(opcode, data)?;
            }
        }
        Ok(true)
    }

    /// Where an error is: before this byte of the file.
    pub fn bytes_read(&self) -> u64 {
        self.bytes_read
    }
}

/// Counts what a record brings.
pub(super) fn count(opcode: u8, body: &[u8], tally: &mut Tally) -> McapResult<()> {
    if opcode == op::ATTACHMENT {
        let (name, media_type, data) = attachment(body).ok_or(McapError::UnexpectedEof)?;
        tally.add_attachment(&name, &media_type, data.len() as u64);
        return Ok(());
    }
    match parse(opcode, body)? {
        Record::Header(header) => tally.library = header.library,
        Record::Schema { header, .. } => {
            tally.schemas.insert(header.id, header.name);
        }
        Record::Channel(channel) => tally.add_channel(channel.id, channel.schema_id, channel.topic),
        Record::Message { header, .. } => tally.add_message(header.channel_id, header.log_time)?,
        Record::Metadata(metadata) => tally.metadata.push(metadata),
        _ => {}
    }
    Ok(())
}

/// Name, media type and content. Read here, as the crate's own parser panics on one that is too short.
pub(super) fn attachment(body: &[u8]) -> Option<(String, String, &[u8])> {
    let mut rest = body.get(16..)?;
    let mut text = || {
        let (length, after) = rest.split_first_chunk::<4>()?;
        let (text, after) = after.split_at_checked(u32::from_le_bytes(*length) as usize)?;
        rest = after;
        Some(String::from_utf8_lossy(text).into_owned())
    };
    let (name, media_type) = (text()?, text()?);
    let (length, data) = rest.split_first_chunk::<8>()?;
    let length = usize::try_from(u64::from_le_bytes(*length)).ok()?;
    Some((name, media_type, data.get(..length)?))
}
