use std::collections::BTreeMap;
use std::io::{Read, Seek, SeekFrom};

use mcap::records::{AttachmentIndex, Channel, ChunkIndex, Footer, MetadataIndex, Record, Statistics, op};
use mcap::{McapError, McapResult};

use super::parse::parse;
use super::tally::{Tally, Topic};

/// Bytes of the footer's record: kind, length, two places, a check sum.
const FOOTER: u64 = 1 + 8 + 8 + 8 + 4;

/// Bytes before the fields of a record: kind and length.
const START: usize = 1 + 8;

/// The magic bytes at both ends.
const MAGIC: u64 = mcap::MAGIC.len() as u64;

/// What the summary at the end of the file says, with the times of each topic from the message indexes; `None` if the
/// file has no summary, or one without counts.
pub(super) fn read_summary(file: &mut (impl Read + Seek), length: u64) -> McapResult<Option<Tally>> {
    check_magic(file, 0)?;
    let end = length.checked_sub(FOOTER + MAGIC).filter(|end| *end >= MAGIC).ok_or(McapError::UnexpectedEof)?;
    check_magic(file, end + FOOTER)?;
    let Ok(Record::Footer(footer)) = record_at(file, end + FOOTER, end, op::FOOTER) else {
        return Err(McapError::BadFooter);
    };
    if footer.summary_start == 0 {
        return Ok(None);
    }
    let summary = Summary::read(file, &footer, end)?;
    check_sum(file, &footer, end)?;
    let Some(statistics) = &summary.statistics else { return Ok(None) };
    let mut tally = Tally { is_complete: true, ..Tally::default() };
    for index in &summary.metadata {
        match record_at(file, length, index.offset, op::METADATA)? {
            Record::Metadata(metadata) => tally.metadata.push(metadata),
            _ => return Err(McapError::BadIndex),
        }
    }
    for index in &summary.attachments {
        tally.add_attachment(&index.name, &index.media_type, index.data_size);
    }
    for (id, channel) in &summary.channels {
        let topic = Topic {
            name: channel.topic.clone(),
            schema: summary.schema(channel)?,
            count: statistics.channel_message_counts.get(id).copied().unwrap_or(0),
            times: times_of(*id, &summary.chunks, file, length)?,
        };
        tally.topics.insert(*id, topic);
    }
    if let Record::Header(header) = record_at(file, length, MAGIC, op::HEADER)? {
        tally.library = header.library;
    }
    Ok(Some(tally))
}

/// What the records of the summary say.
#[derive(Default)]
struct Summary {
    statistics: Option<Statistics>,
    /// Their names.
    schemas: BTreeMap<u16, String>,
    channels: BTreeMap<u16, Channel>,
    chunks: Vec<ChunkIndex>,
    attachments: Vec<AttachmentIndex>,
    metadata: Vec<MetadataIndex>,
}

impl Summary {
    /// Reads it up to the footer, which begins at `end`. Not by the crate's reader, which makes room for texts by what
    /// they claim to be, and takes a footer of any length.
    fn read(file: &mut (impl Read + Seek), footer: &Footer, end: u64) -> McapResult<Self> {
        let mut left = end.checked_sub(footer.summary_start).ok_or(McapError::BadIndex)?;
        file.seek(SeekFrom::Start(footer.summary_start))?;
        let mut found = Self::default();
        while left > 0 {
            let (opcode, body) = fields(file, left)?;
            left -= (START + body.len()) as u64;
            match parse(opcode, &body)?.into_owned() {
                Record::Statistics(statistics) => found.statistics = Some(statistics),
                Record::Schema { header, .. } => {
                    found.schemas.insert(header.id, header.name);
                }
                Record::Channel(channel) => {
                    found.channels.insert(channel.id, channel);
                }
                Record::ChunkIndex(index) => found.chunks.push(index),
                Record::AttachmentIndex(index) => found.attachments.push(index),
                Record::MetadataIndex(index) => found.metadata.push(index),
                _ => {}
            }
        }
        Ok(found)
    }

    /// The name of a channel's schema; 0 stands for none.
    fn schema(&self, channel: &Channel) -> McapResult<String> {
        match (channel.schema_id, self.schemas.get(&channel.schema_id)) {
            (_, Some(name)) => Ok(name.clone()),
            (0, None) => Ok(String::new()),
            (id, None) => Err(McapError::UnknownSchema(channel.topic.clone(), id)),
        }
    }
}

fn check_magic(file: &mut (impl Read + Seek), place: u64) -> McapResult<()> {
    let mut magic = [0; mcap::MAGIC.len()];
    file.seek(SeekFrom::Start(place))?;
    match file.read_exact(&mut magic) {
        Ok(()) if magic == mcap::MAGIC => Ok(()),
        _ => Err(McapError::BadMagic),
    }
}

/// Holds the summary against its check sum: from where it starts to within the footer, which begins at `end`.
fn check_sum(file: &mut (impl Read + Seek), footer: &Footer, end: u64) -> McapResult<()> {
    let saved = footer.summary_crc;
    let Some(size) = (end + FOOTER - 4).checked_sub(footer.summary_start) else { return Err(McapError::BadIndex) };
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

/// The record of kind `opcode` at `offset`, which ends before `end`.
fn record_at(file: &mut (impl Read + Seek), end: u64, offset: u64, opcode: u8) -> McapResult<Record<'static>> {
    file.seek(SeekFrom::Start(offset))?;
    match fields(file, end.saturating_sub(offset))? {
        (found, body) if found == opcode => Ok(parse(opcode, &body)?.into_owned()),
        _ => Err(McapError::BadIndex),
    }
}

/// Kind and fields of the record that comes next, of which `left` bytes are there at most.
fn fields(file: &mut impl Read, left: u64) -> McapResult<(u8, Vec<u8>)> {
    let mut start = [0; START];
    file.read_exact(&mut start).map_err(|_| McapError::BadIndex)?;
    let [opcode, size @ ..] = start;
    let size = u64::from_le_bytes(size);
    if left.checked_sub(START as u64).is_none_or(|rest| size > rest) {
        return Err(McapError::BadIndex);
    }
    let mut body = Vec::new();
    if file.take(size).read_to_end(&mut body)? as u64 == size {
        Ok((opcode, body))
    } else {
        Err(McapError::UnexpectedEof)
    }
}
