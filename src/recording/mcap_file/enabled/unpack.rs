use std::io::Read;

use lz4_flex::frame::FrameDecoder;
use mcap::records::{Record, op};
use mcap::{McapError, McapResult};

use super::parse::parse;

/// The records of a chunk, unpacked and found right before the first is lent, and how far they were read.
///
/// Unpacked here, as the crate's own reader takes a record that is longer than its chunk for one that goes on behind it.
#[derive(Default)]
pub(super) struct Unpacked {
    records: Vec<u8>,
    place: usize,
}

impl Unpacked {
    /// The records of this chunk in place of those of the last.
    ///
    /// # Errors
    /// If it is longer than `most`, of an unknown compression, of another length or check sum than it says.
    pub fn unpack(&mut self, chunk: &[u8], most: u64) -> McapResult<()> {
        let Record::Chunk { header, data } = parse(op::CHUNK, chunk)? else { return Err(McapError::UnexpectedEoc) };
        let size = header.uncompressed_size;
        if size > most {
            return Err(McapError::ChunkTooLarge(size));
        }
        self.place = 0;
        self.records.clear();
        // No more than there is, and one byte more than there should be: room is made as it is needed.
        let unpacked = match header.compression.as_str() {
            "" => data.take(size + 1).read_to_end(&mut self.records),
            "zstd" => zstd::stream::read::Decoder::with_buffer(&*data)
                .and_then(|unpacked| unpacked.take(size + 1).read_to_end(&mut self.records)),
            "lz4" => FrameDecoder::new(&*data).take(size + 1).read_to_end(&mut self.records),
            other => return Err(McapError::UnsupportedCompression(other.to_owned())),
        };
        let found = unpacked.map_err(|error| McapError::DecompressionError(error.to_string()))? as u64;
        if found != size {
            return Err(McapError::BadChunkLength { header: size, available: found });
        }
        let (saved, calculated) = (header.uncompressed_crc, crc32fast::hash(&self.records));
        if saved != 0 && saved != calculated {
            return Err(McapError::BadChunkCrc { saved, calculated });
        }
        Ok(())
    }

    /// Kind and fields of the next record; `None` after the last.
    ///
    /// # Errors
    /// If it is longer than what is left of the chunk.
    pub fn advance(&mut self) -> McapResult<Option<(u8, &[u8])>> {
        let rest = &self.records[self.place..];
        if rest.is_empty() {
            return Ok(None);
        }
        let ([opcode, length @ ..], after) = rest.split_first_chunk::<9>().ok_or(McapError::UnexpectedEoc)?;
        let length = usize::try_from(u64::from_le_bytes(*length)).map_err(|_| McapError::UnexpectedEoc)?;
        let body = after.get(..length).ok_or(McapError::UnexpectedEoc)?;
        self.place += 9 + length;
        Ok(Some((*opcode, body)))
    }
}
