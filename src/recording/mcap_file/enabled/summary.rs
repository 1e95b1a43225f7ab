use std::collections::BTreeMap;
use std::io::{Read, Seek, SeekFrom};

use mcap::records::{ChunkIndex, Record, op};
use mcap::sans_io::summary_reader::{SummaryReadEvent, SummaryReader, SummaryReaderOptions};
use mcap::{McapError, McapResult, Summary};

use super::parse::{check, parse};
use super::tally::{Tally, Topic};

/// Bytes of the footer's record: kind, length, two places, a check sum.
const FOOTER: u64 = 1 + 8 + 8 + 8 + 4;

/// Bytes before the fields of a record: kind and length.
const START: usize = 1 + 8;

/// What the summary at the end of the file says, with the times of each topic from the message indexes; `None` if the
/// file has no summary, or one without counts.
pub(super) fn read_summary(file: &mut (impl Read + Seek), length: u64) -> McapResult<Option<Tally>> {
    check_start(file)?;
    check_texts(file, length)?;
    let Some(summary) = summary_at_end(file, length)? else { return Ok(None) };
    check_summary(file, length)?;
    let Some(statistics) = &summary.stats else { return Ok(None) };
    let mut tally = Tally { is_complete: true, ..Tally::default() };
    for index in &summary.metadata_indexes {
        match record_at(file, length, index.offset, op::METADATA)? {
            Record::Metadata(metadata) => tally.metadata.push(metadata),
            _ => return Err(McapError::BadIndex),
        }
    }
    for index in &summary.attachment_indexes {
        tally.add_attachment(&index.name, &index.media_type, index.data_size);
    }
    for (id, channel) in &summary.channels {
        let topic = Topic {
            name: channel.topic.clone(),
            schema: channel.schema.as_ref().map_or_else(String::new, |schema| schema.name.clone()),
            count: statistics.channel_message_counts.get(id).copied().unwrap_or(0),
            times: times_of(*id, &summary.chunk_indexes, file, length)?,
        };
        tally.topics.insert(*id, topic);
    }
    if let Record::Header(header) = record_at(file, length, mcap::MAGIC.len() as u64, op::HEADER)? {
        tally.library = header.library;
    }
    Ok(Some(tally))
}

fn check_start(file: &mut (impl Read + Seek)) -> McapResult<()> {
    let mut magic = [0; mcap::MAGIC.len()];
    file.rewind()?;
    match file.read_exact(&mut magic) {
        Ok(()) if magic == mcap::MAGIC => Ok(()),
        _ => Err(McapError::BadMagic),
    }
}

/// Holds the texts of the summary against what is there, as far as its records follow one another; whether they do is for
/// the crate's reader to say.
fn check_texts(file: &mut (impl Read + Seek), length: u64) -> McapResult<()> {
    let end = length.saturating_sub(mcap::MAGIC.len() as u64 + FOOTER);
    let Ok(Record::Footer(footer)) = record_at(file, length, end, op::FOOTER) else { return Ok(()) };
    if footer.summary_start == 0 || footer.summary_start > end {
        return Ok(());
    }
    let mut place = footer.summary_start;
    file.seek(SeekFrom::Start(place))?;
    let (mut start, mut body) = ([0; START], Vec::new());
    while place + START as u64 <= end {
        file.read_exact(&mut start)?;
        let [opcode, size @ ..] = start;
        let size = u64::from_le_bytes(size);
        if size > end - place {
            break;
        }
        body.clear();
        file.take(size).read_to_end(&mut body)?;
        check(opcode, &body)?;
        place += START as u64 + size;
    }
    Ok(())
}

fn summary_at_end(file: &mut (impl Read + Seek), length: u64) -> McapResult<Option<Summary>> {
    let mut reader = SummaryReader::new_with_options(SummaryReaderOptions::default().with_file_size(length));
    while let Some(event) = reader.next_event() {
        match event? {
            SummaryReadEvent::ReadRequest(bytes) => {
                let read = file.read(reader.insert(bytes))?;
                reader.notify_read(read);
            }
            SummaryReadEvent::SeekRequest(to) => reader.notify_seeked(file.seek(to)?),
        }
    }
    Ok(reader.finish())
}

/// Holds the summary against its check sum, which the crate's reader does not: from where it starts to within the footer.
fn check_summary(file: &mut (impl Read + Seek), length: u64) -> McapResult<()> {
    let end = length.saturating_sub(mcap::MAGIC.len() as u64);
    let footer = end.checked_sub(FOOTER).ok_or(McapError::UnexpectedEof)?;
    let Record::Footer(footer) = record_at(file, length, footer, op::FOOTER)? else { return Err(McapError::BadIndex) };
    let saved = footer.summary_crc;
    let Some(size) = (end - 4).checked_sub(footer.summary_start) else { return Err(McapError::BadIndex) };
    if saved == 0 {
        return Ok(());
    }
    file.seek(SeekFrom::Start(footer.summary_start))?;
    let (mut rest, mut piece, mut checksum) = (file.take(size), [0; 4096], crc32fast::Hasher::new());
    loop {
        match rest.read(&mut piece)? {
            0 => break,
            read => checksum.update(&piece[..read]),
        }
    }
    let calculated = checksum.finalize();
    if calculated == saved { Ok(()) } else { Err(McapError::BadSummaryCrc { saved, calculated }) }
}

/// First and last log time of a channel: the indexes of as few chunks are read as tell.
fn times_of(
    channel: u16,
    chunks: &[ChunkIndex],
    file: &mut (impl Read + Seek),
    length: u64,
) -> McapResult<Option<(u64, u64)>> {
    let with_channel = |chunk: &&ChunkIndex| chunk.message_index_offsets.contains_key(&channel);
    let mut chunks: Vec<_> = chunks.iter().filter(with_channel).collect();
    let mut read = BTreeMap::new();
    let mut times_in = |chunk: &ChunkIndex| -> McapResult<Option<(u64, u64)>> {
        let Some(offset) = chunk.message_index_offsets.get(&channel) else { return Ok(None) };
        if let Some(times) = read.get(offset) {
            return Ok(*times);
        }
        let Record::MessageIndex(index) = record_at(file, length, *offset, op::MESSAGE_INDEX)? else {
            return Err(McapError::BadIndex);
        };
        let times = || index.records.iter().map(|entry| entry.log_time);
        let times = times().min().zip(times().max());
        read.insert(*offset, times);
        Ok(times)
    };
    let (mut first, mut last) = (u64::MAX, None);
    chunks.sort_by_key(|chunk| chunk.message_start_time);
    for chunk in &chunks {
        if chunk.message_start_time >= first {
            break;
        }
        first = times_in(chunk)?.map_or(first, |(start, _)| first.min(start));
    }
    chunks.sort_by_key(|chunk| std::cmp::Reverse(chunk.message_end_time));
    for chunk in &chunks {
        if last.is_some_and(|last| chunk.message_end_time <= last) {
            break;
        }
        last = last.max(times_in(chunk)?.map(|(_, end)| end));
    }
    Ok(last.map(|last| (first.min(last), last)))
}

/// The record of kind `opcode` at `offset`.
fn record_at(file: &mut (impl Read + Seek), length: u64, offset: u64, opcode: u8) -> McapResult<Record<'static>> {
    let mut start = [0; START];
    file.seek(SeekFrom::Start(offset))?;
    file.read_exact(&mut start).map_err(|_| McapError::BadIndex)?;
    let [found, size @ ..] = start;
    let size = u64::from_le_bytes(size);
    if found != opcode || size > length.saturating_sub(offset) {
        return Err(McapError::BadIndex);
    }
    let mut body = Vec::new();
    file.take(size).read_to_end(&mut body)?;
    Ok(parse(opcode, &body)?.into_owned())
}
