//! What no writer of the same bytes can do without.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use mcap::parse_record;
use mcap::records::Record;
use zstd::bulk::Compressor;
use zstd::zstd_safe::{CParameter, compress_bound};

use super::clock::{cost, median};

/// Headings of the floors after that of the disk.
pub const HEADINGS: &str = " floor: memory | zstd level 1 | zstd as tuned |";

/// µs a sample.
#[derive(Debug, Clone, Copy, Default)]
pub struct Floors {
    /// Bytes a sample of the files.
    pub bytes: f64,
    /// Giving the files' bytes to the disk, synced.
    pub disk: f64,
    /// Copying them once.
    pub copy: f64,
    /// Compressing what the `.mcap`'s chunks hold, each in one call; 0 where there are none.
    level_1: f64,
    tuned: f64,
}

impl Floors {
    /// Those of compression.
    pub fn packing(&self) -> [(&'static str, f64); 2] {
        [("zstd level 1", self.level_1), ("zstd as tuned", self.tuned)]
    }
}

/// Of the files of a recording of so many samples.
pub fn of(paths: &[PathBuf], samples: u32) -> Floors {
    let mut floors = Floors::default();
    for path in paths {
        let bytes = fs::read(path).expect("it was recorded");
        floors.bytes += f64::from(u32::try_from(bytes.len()).expect("below 4 GiB")) / f64::from(samples);
        floors.disk += least(samples, || write(&path.with_extension("floor"), &bytes));
        let mut copy = vec![0; 1 << 20];
        floors.copy += least(samples, || {
            for piece in bytes.chunks(copy.len()) {
                copy[..piece.len()].copy_from_slice(piece);
                std::hint::black_box(&mut copy);
            }
        });
        if path.extension().is_some_and(|extension| extension == "mcap") {
            let chunks = chunks(&bytes);
            floors.level_1 += least(samples, || pack(&chunks, &[]));
            floors.tuned += least(samples, || pack(&chunks, &TUNING));
        }
    }
    floors
}

/// As `.mcap` chunks are compressed.
const TUNING: [CParameter; 3] = [CParameter::MinMatch(4), CParameter::HashLog(12), CParameter::TargetLength(1)];

fn least(samples: u32, mut work: impl FnMut()) -> f64 {
    let costs: Vec<_> = (0..super::ROUNDS).map(|_| cost(samples, &mut work)).collect();
    median(&costs, |cost| cost.cpu)
}

fn write(path: &Path, bytes: &[u8]) {
    let mut file = File::create(path).expect("a file");
    bytes.chunks(1 << 20).try_for_each(|piece| file.write_all(piece)).expect("room");
    file.sync_all().expect("synced");
    fs::remove_file(path).expect("removed");
}

/// What the chunks of an `.mcap` hold.
fn chunks(bytes: &[u8]) -> Vec<Vec<u8>> {
    let mut chunks = Vec::new();
    let mut rest = &bytes[mcap::MAGIC.len()..bytes.len() - mcap::MAGIC.len()];
    while let Some((start, after)) = rest.split_first_chunk::<9>() {
        let length = u64::from_le_bytes(start[1..].try_into().expect("eight bytes"));
        let (body, after) = after.split_at(usize::try_from(length).expect("in memory"));
        if start[0] == mcap::records::op::CHUNK
            && let Ok(Record::Chunk { header, data }) = parse_record(start[0], body)
        {
            let unpacked = usize::try_from(header.uncompressed_size).expect("in memory");
            chunks.push(zstd::bulk::decompress(&data, unpacked).expect("a whole chunk"));
        }
        rest = after;
    }
    chunks
}

fn pack(chunks: &[Vec<u8>], tuning: &[CParameter]) {
    let mut compressor = Compressor::new(1).expect("a compressor");
    tuning.iter().try_for_each(|parameter| compressor.set_parameter(*parameter)).expect("zstd knows them");
    let mut packed = Vec::new();
    for chunk in chunks {
        packed.clear();
        packed.reserve(compress_bound(chunk.len()));
        compressor.compress_to_buffer(chunk, &mut packed).expect("room");
        std::hint::black_box(&packed);
    }
}
