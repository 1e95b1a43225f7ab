use std::io;

use zstd::bulk::Compressor;
use zstd::zstd_safe::compress_bound;

use super::record::{Kind, by_channel, numbers, record, text, with_length};

/// Records that are compressed together, in the making.
pub(super) struct Chunk {
    records: Vec<u8>,
    /// Of each channel, by its number less one: times and places of its messages.
    index: Vec<Vec<(u64, u64)>>,
    times: Option<(u64, u64)>,
    compressor: Compressor<'static>,
    compressed: Vec<u8>,
}

impl Chunk {
    /// Bytes after which a chunk is closed, before compression.
    pub const SIZE: usize = 1 << 20;
    const COMPRESSION: &'static str = "zstd";
    /// The fastest: the next ones cost a third more for nothing, as mantissas hardly compress.
    const LEVEL: i32 = 1;

    pub fn new() -> io::Result<Self> {
        Ok(Self {
            records: Vec::with_capacity(Self::SIZE + Self::SIZE / 8),
            index: Vec::new(),
            times: None,
            compressor: Compressor::new(Self::LEVEL)?,
            compressed: Vec::new(),
        })
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
        self.index[place].push((time, self.records.len() as u64));
        self.times = Some(self.times.map_or((time, time), |(first, last)| (first.min(time), last.max(time))));
        record(&mut self.records, Kind::Message, |bytes| {
            bytes.extend_from_slice(&channel.to_le_bytes());
            bytes.extend_from_slice(&sequence.to_le_bytes());
            numbers(bytes, [time, time]);
            data(bytes);
        });
    }

    /// Appends the chunk and its message indexes to `bytes`, which stand at `position` in the file, and its index to
    /// `chunk_indexes`; then it is empty. Whether there was anything in it.
    pub fn close(&mut self, bytes: &mut Vec<u8>, position: u64, chunk_indexes: &mut Vec<u8>) -> io::Result<bool> {
        if self.records.is_empty() {
            return Ok(false);
        }
        self.compressed.clear();
        self.compressed.reserve(compress_bound(self.records.len()));
        self.compressor.compress_to_buffer(&self.records, &mut self.compressed)?;
        let (first, last) = self.times.unwrap_or((0, 0));
        let start = bytes.len();
        record(bytes, Kind::Chunk, |bytes| {
            numbers(bytes, [first, last, self.records.len() as u64]);
            bytes.extend_from_slice(&crc32fast::hash(&self.records).to_le_bytes());
            text(bytes, Self::COMPRESSION);
            with_length::<u64>(bytes, |bytes| bytes.extend_from_slice(&self.compressed));
        });
        let length = (bytes.len() - start) as u64;
        let places = self.message_indexes(bytes, position - start as u64);
        let index_length = (bytes.len() - start) as u64 - length;
        record(chunk_indexes, Kind::ChunkIndex, |bytes| {
            numbers(bytes, [first, last, position, length]);
            by_channel(bytes, places);
            numbers(bytes, [index_length]);
            text(bytes, Self::COMPRESSION);
            numbers(bytes, [self.compressed.len() as u64, self.records.len() as u64]);
        });
        self.records.clear();
        self.index.iter_mut().for_each(Vec::clear);
        self.times = None;
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
                with_length::<u32>(bytes, |bytes| {
                    for (time, offset) in entries {
                        numbers(bytes, [*time, *offset]);
                    }
                });
            });
        }
        places
    }
}
