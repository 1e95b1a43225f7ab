use std::io::{Read, Seek};

use mcap::records::{Record, op};
use mcap::sans_io::linear_reader::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{McapError, McapResult, parse_record};

use super::tally::Tally;

/// No record is longer, in the file or in a chunk: what a damaged length asks for is not allocated.
const LONGEST_RECORD: u64 = 1 << 28;

/// Goes through the file from its start, checking every checksum; what was met until an error is in `tally`.
pub(super) fn scan(file: &mut (impl Read + Seek), length: u64, tally: &mut Tally) -> McapResult<()> {
    file.rewind()?;
    let limit = usize::try_from(LONGEST_RECORD.min(length.max(1 << 20))).unwrap_or(usize::MAX);
    let options = LinearReaderOptions::default().with_validate_chunk_crcs(true).with_record_length_limit(limit);
    let mut reader = LinearReader::new_with_options(options);
    while let Some(event) = reader.next_event() {
        match event? {
            LinearReadEvent::ReadRequest(bytes) => {
                let read = file.read(reader.insert(bytes))?;
                tally.bytes_read += read as u64;
                reader.notify_read(read);
            }
            LinearReadEvent::Record { data, opcode } => add(opcode, data, tally)?,
        }
    }
    Ok(())
}

fn add(opcode: u8, body: &[u8], tally: &mut Tally) -> McapResult<()> {
    if opcode == op::ATTACHMENT {
        let (name, media_type, bytes) = attachment(body).ok_or(McapError::UnexpectedEof)?;
        tally.add_attachment(&name, &media_type, bytes);
        return Ok(());
    }
    match parse_record(opcode, body)? {
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

/// Name, media type and length. Read here, as the crate's own parser panics on one that is too short.
fn attachment(body: &[u8]) -> Option<(String, String, u64)> {
    let mut rest = body.get(16..)?;
    let mut text = || {
        let (length, after) = rest.split_first_chunk::<4>()?;
        let (text, after) = after.split_at_checked(u32::from_le_bytes(*length) as usize)?;
        rest = after;
        Some(String::from_utf8_lossy(text).into_owned())
    };
    let (name, media_type) = (text()?, text()?);
    let (length, data) = rest.split_first_chunk::<8>()?;
    let length = u64::from_le_bytes(*length);
    (data.len() as u64 >= length).then_some((name, media_type, length))
}
