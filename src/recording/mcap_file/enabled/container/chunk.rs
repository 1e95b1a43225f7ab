use std::io::{self, Cursor};

use zstd::bulk::Compressor;
use zstd::zstd_safe::{CParameter, compress_bound};

use super::ending::Ending;
use super::record::{Kind, by_channel, numbers, record, text, with_length};

/// Records that are compressed together, in the making.
pub(super) struct Chunk {
    records: Vec<u8>,
    /// Of each channel, by its number less one: the entries of its message index, time and place of each message.
    index: Vec<Vec<u8>>,
    times: Option<(u64, u64)>,
    compressor: Compressor<'static>,
}

impl Chunk {
    /// Bytes after which a chunk is closed, before compression.
    pub const SIZE: usize = 1 << 20;
    const COMPRESSION: &'static str = "zstd";
    /// The fastest that is still thorough: the next ones cost a third more for nothing.
    const LEVEL: i32 = 1;
    /// What the level is changed in, for messages of f64. Their mantissas do not compress, so what saves bytes are short
    /// repetitions a message apart: keys with the first bytes of slowly varying numbers. They are looked for from four
    /// bytes on (the level: seven), in a table that stays in the nearest cache; and what is left is stored as it is,
    /// not Huffman-coded, which is what a target length does at this level. As large, in four fifths of the time.
    const TUNING: [CParameter; 3] = [CParameter::MinMatch(4), CParameter::HashLog(12), CParameter::TargetLength(1)];
    /// Bytes of a message record before its content: kind, length, channel, sequence, two times.
    const MESSAGE_HEADER: usize = 1 + 8 + 2 + 4 + 8 + 8;

    pub fn new() -> io::Result<Self> {
        let mut compressor = Compressor::new(Self::LEVEL)?;
        Self::TUNING.into_iter().try_for_each(|parameter| compressor.set_parameter(parameter))?;
        let records = Vec::with_capacity(Self::SIZE + Self::SIZE / 8);
        Ok(Self { records, index: Vec::new(), times: None, compressor })
    }

    pub fn is_full(&self) -> bool {
        self.records.len() > Self::SIZE
    }

    /// Where records that are no messages go.
    pub fn records(&mut self) -> &mut Vec<u8> {
        &mut self.records
    }

    /// Adds a message; `data` appends its content.
    pub fn message(&mut self, (channel, sequence): (u16, u32), time: u64, data: impl FnOnce(&mut Vec<u8>)) {
        let place = usize::from(channel).saturating_sub(1);
        if self.index.len() <= place {
            self.index.resize_with(place + 1, Vec::new);
        }
        let start = self.records.len();
        numbers(&mut self.index[place], [time, start as u64]);
        self.times = Some(self.times.map_or((time, time), |(first, last)| (first.min(time), last.max(time))));
        // In one piece, by constant places: this is done for every sample.
        let mut header = [0; Self::MESSAGE_HEADER];
        header[0] = Kind::Message as u8;
        header[9..11].copy_from_slice(&channel.to_le_bytes());
        header[11..15].copy_from_slice(&sequence.to_le_bytes());
        header[15..23].copy_from_slice(&time.to_le_bytes());
        header[23..31].copy_from_slice(&time.to_le_bytes());
        self.records.extend_from_slice(&header);
        data(&mut self.records);
        let length = (self.records.len() - start - 9) as u64;
        self.records[start + 1..start + 9].copy_from_slice(&length.to_le_bytes());
    }

    /// Appends the chunk and its message indexes to `bytes`, which stand at `position` in the file, and notes in
    /// `ending` what the file's end says of them; then it is empty. Whether there was anything in it.
    pub fn close(&mut self, bytes: &mut Vec<u8>, position: u64, ending: &mut Ending) -> io::Result<bool> {
        if self.records.is_empty() {
            return Ok(false);
        }
        let (first, last) = self.times.unwrap_or((0, 0));
        let start = bytes.len();
        let mut compressed = 0;
        let mut outcome = Ok(());
        record(bytes, Kind::Chunk, |bytes| {
            numbers(bytes, [first, last, self.records.len() as u64]);
            bytes.extend_from_slice(&crc32fast::hash(&self.records).to_le_bytes());
            text(bytes, Self::COMPRESSION);
            with_length::<u64>(bytes, |bytes| {
                let before = bytes.len();
                outcome = append_compressed(&mut self.compressor, &self.records, bytes);
                compressed = (bytes.len() - before) as u64;
            });
        });
        if outcome.is_err() {
            bytes.truncate(start);
            return outcome.map(|()| false);
        }
        let length = (bytes.len() - start) as u64;
        let places = self.message_indexes(bytes, position - start as u64);
        let index_length = (bytes.len() - start) as u64 - length;
        ending.chunk_indexes.add(Kind::ChunkIndex, |bytes| {
            numbers(bytes, [first, last, position, length]);
            by_channel(bytes, places);
            numbers(bytes, [index_length]);
            text(bytes, Self::COMPRESSION);
            numbers(bytes, [compressed, self.records.len() as u64]);
        });
        if let Some(times) = self.times.take() {
            ending.count(self.index.iter().map(|entries| (entries.len() / 16) as u64), times);
        }
        self.records.clear();
        self.index.iter_mut().for_each(Vec::clear);
        Ok(true)
    }

    /// Appends an index for each channel that has messages; where each is in a file whose byte `origin` is `bytes[0]`.
    fn message_indexes(&self, bytes: &mut Vec<u8>, origin: u64) -> Vec<(u16, u64)> {
        let mut places = Vec::new();
        for (channel, entries) in (1_u16..).zip(&self.index) {
            if entries.is_empty() {
                continue;
            }
            places.push((channel, origin + bytes.len() as u64));
            record(bytes, Kind::MessageIndex, |bytes| {
                bytes.extend_from_slice(&channel.to_le_bytes());
                with_length::<u32>(bytes, |bytes| bytes.extend_from_slice(entries));
            });
        }
        places
    }
}

/// Appends `records`, compressed in one piece where they come to stand.
fn append_compressed(compressor: &mut Compressor<'_>, records: &[u8], bytes: &mut Vec<u8>) -> io::Result<()> {
    bytes.reserve(compress_bound(records.len()));
    let position = bytes.len() as u64;
    let mut place = Cursor::new(std::mem::take(bytes));
    place.set_position(position);
    let outcome = compressor.compress_to_buffer(records, &mut place);
    *bytes = place.into_inner();
    outcome.map(|_| ())
}
