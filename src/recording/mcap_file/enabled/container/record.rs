//! The records of an `.mcap` (<https://mcap.dev/spec>): one byte of kind, eight of length, the fields; little-endian.

use std::collections::BTreeMap;

/// First and last bytes of a file.
pub(super) const MAGIC: [u8; 8] = [0x89, b'M', b'C', b'A', b'P', b'0', b'\r', b'\n'];

/// What a record is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Header = 0x01,
    Footer = 0x02,
    Schema = 0x03,
    Channel = 0x04,
    Message = 0x05,
    Chunk = 0x06,
    MessageIndex = 0x07,
    ChunkIndex = 0x08,
    Attachment = 0x09,
    AttachmentIndex = 0x0a,
    Statistics = 0x0b,
    Metadata = 0x0c,
    MetadataIndex = 0x0d,
    SummaryOffset = 0x0e,
    DataEnd = 0x0f,
}

/// Appends a record whose fields `fields` appends.
pub(super) fn record(bytes: &mut Vec<u8>, kind: Kind, fields: impl FnOnce(&mut Vec<u8>)) {
    bytes.push(kind as u8);
    with_length::<u64>(bytes, fields);
}

/// A width in which lengths are written.
pub(super) trait Length {
    fn put(length: usize, bytes: &mut Vec<u8>, at: usize);
    const ZERO: &'static [u8];
}

impl Length for u64 {
    const ZERO: &'static [u8] = &[0; 8];

    fn put(length: usize, bytes: &mut Vec<u8>, at: usize) {
        bytes[at..at + 8].copy_from_slice(&(length as u64).to_le_bytes());
    }
}

impl Length for u32 {
    const ZERO: &'static [u8] = &[0; 4];

    /// Names, schemas and indexes of one chunk: far below 4 GiB.
    fn put(length: usize, bytes: &mut Vec<u8>, at: usize) {
        let length = u32::try_from(length).unwrap_or(u32::MAX);
        bytes[at..at + 4].copy_from_slice(&length.to_le_bytes());
    }
}

/// Appends what `content` appends, its length before it.
pub(super) fn with_length<L: Length>(bytes: &mut Vec<u8>, content: impl FnOnce(&mut Vec<u8>)) {
    let at = bytes.len();
    bytes.extend_from_slice(L::ZERO);
    let start = bytes.len();
    content(bytes);
    L::put(bytes.len() - start, bytes, at);
}

/// Appends a string.
pub(super) fn text(bytes: &mut Vec<u8>, text: &str) {
    with_length::<u32>(bytes, |bytes| bytes.extend_from_slice(text.as_bytes()));
}

/// Appends a map from strings to strings.
pub(super) fn texts(bytes: &mut Vec<u8>, map: &BTreeMap<String, String>) {
    with_length::<u32>(bytes, |bytes| {
        for (key, value) in map {
            text(bytes, key);
            text(bytes, value);
        }
    });
}

/// Appends a map from channels to numbers.
pub(super) fn by_channel(bytes: &mut Vec<u8>, map: impl IntoIterator<Item = (u16, u64)>) {
    with_length::<u32>(bytes, |bytes| {
        for (channel, number) in map {
            bytes.extend_from_slice(&channel.to_le_bytes());
            numbers(bytes, [number]);
        }
    });
}

/// Appends numbers of eight bytes.
pub(super) fn numbers<const N: usize>(bytes: &mut Vec<u8>, numbers: [u64; N]) {
    for number in numbers {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
}
