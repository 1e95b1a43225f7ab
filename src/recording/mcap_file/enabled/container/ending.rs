use super::record::{Kind, MAGIC, by_channel, numbers, record};

/// What the end of a file repeats and counts, as records ready to be written.
#[derive(Default)]
pub(super) struct Ending {
    pub schemas: Group,
    pub channels: Group,
    pub chunk_indexes: Group,
    pub attachment_indexes: Group,
    pub metadata_indexes: Group,
    /// Messages of each channel, by its number less one.
    pub messages: Vec<u64>,
    /// Log times of the first and the last message.
    pub times: Option<(u64, u64)>,
}

/// Records of one kind.
#[derive(Default)]
pub(super) struct Group {
    pub count: u32,
    pub records: Vec<u8>,
}

impl Group {
    /// Adds a record whose fields `fields` appends.
    pub fn add(&mut self, kind: Kind, fields: impl FnOnce(&mut Vec<u8>)) {
        record(&mut self.records, kind, fields);
        self.count += 1;
    }

    /// Adds a record as it stands elsewhere.
    pub fn repeat(&mut self, record: &[u8]) {
        self.records.extend_from_slice(record);
        self.count += 1;
    }
}

impl Ending {
    /// Counts the messages of a chunk: of each channel, in order, and the times of the first and the last of them.
    pub fn count(&mut self, messages: impl Iterator<Item = u64>, (first, last): (u64, u64)) {
        self.messages.iter_mut().zip(messages).for_each(|(sum, count)| *sum += count);
        self.times = Some(self.times.map_or((first, last), |times| (times.0.min(first), times.1.max(last))));
    }

    /// Appends what comes after the last chunk: `bytes` stand at `position` in the file, and the checksum of everything
    /// before is `data_crc`.
    pub fn write(&self, bytes: &mut Vec<u8>, position: u64, data_crc: u32) {
        let origin = position - bytes.len() as u64;
        record(bytes, Kind::DataEnd, |bytes| bytes.extend_from_slice(&data_crc.to_le_bytes()));
        let start = bytes.len();
        let statistics = self.statistics();
        let groups = [
            (Kind::Schema, &self.schemas.records),
            (Kind::Channel, &self.channels.records),
            (Kind::Statistics, &statistics),
            (Kind::ChunkIndex, &self.chunk_indexes.records),
            (Kind::AttachmentIndex, &self.attachment_indexes.records),
            (Kind::MetadataIndex, &self.metadata_indexes.records),
        ];
        let mut offsets = Vec::new();
        for (kind, records) in groups.into_iter().filter(|(_, records)| !records.is_empty()) {
            record(&mut offsets, Kind::SummaryOffset, |offsets| {
                offsets.push(kind as u8);
                numbers(offsets, [origin + bytes.len() as u64, records.len() as u64]);
            });
            bytes.extend_from_slice(records);
        }
        let offsets_start = origin + bytes.len() as u64;
        bytes.extend_from_slice(&offsets);
        record(bytes, Kind::Footer, |bytes| {
            numbers(bytes, [origin + start as u64, offsets_start]);
            // Of the summary and of the footer up to here, its length included.
            let length = 20_u64.to_le_bytes();
            let place = bytes.len() - 16 - length.len();
            bytes[place..place + length.len()].copy_from_slice(&length);
            bytes.extend_from_slice(&crc32fast::hash(&bytes[start..]).to_le_bytes());
        });
        bytes.extend_from_slice(&MAGIC);
    }

    fn statistics(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let (first, last) = self.times.unwrap_or((0, 0));
        record(&mut bytes, Kind::Statistics, |bytes| {
            numbers(bytes, [self.messages.iter().sum()]);
            bytes.extend_from_slice(&u16::try_from(self.schemas.count).unwrap_or(u16::MAX).to_le_bytes());
            for group in [&self.channels, &self.attachment_indexes, &self.metadata_indexes, &self.chunk_indexes] {
                bytes.extend_from_slice(&group.count.to_le_bytes());
            }
            numbers(bytes, [first, last]);
            by_channel(bytes, (1..).zip(self.messages.iter().copied()).filter(|(_, count)| *count > 0));
        });
        bytes
    }
}
