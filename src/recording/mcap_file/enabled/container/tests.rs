use std::collections::BTreeMap;
use std::fs;
use std::io::Read;

use mcap::records::{ChunkIndex, MessageHeader, Metadata, Record, op};
use mcap::sans_io::linear_reader::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{Attachment, Compression, WriteOptions};

use super::Output;
use crate::recording::PartFile;

const SCHEMA: (&str, &[u8]) = ("a.Message", b"descriptor");
const TOPICS: [&str; 3] = ["/one", "/silent", "/two"];
/// Enough for three chunks.
const MESSAGES: u64 = 12_000;

fn metadata() -> Metadata {
    Metadata { name: "facts".into(), metadata: [("key".into(), "value".into())].into() }
}

fn attachment() -> Attachment<'static> {
    Attachment {
        log_time: 1,
        create_time: 2,
        name: "scene.toml".into(),
        media_type: "application/toml".into(),
        data: b"text"[..].into(),
    }
}

/// Topic, time and content: times fall back now and then.
fn message(number: u64) -> (usize, u64, Vec<u8>) {
    let topic = if number.is_multiple_of(5) { 2 } else { 0 };
    let content = (0..200).map(|byte| (number.wrapping_mul(byte) >> 3).to_le_bytes()[0]).collect();
    (topic, 1000 + (number ^ 1), content)
}

fn by_polhode() -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("run.mcap");
    let mut output = Output::create(PartFile::create(&path, false).expect("created")).expect("begun");
    output.describe(&metadata()).expect("described");
    output.attach(&attachment()).expect("attached");
    let mut topics = TOPICS.map(|topic| output.topic(topic, SCHEMA, &BTreeMap::new()).expect("a topic"));
    for (topic, time, content) in (0..MESSAGES).map(message) {
        let stamp = time.cast_signed();
        output.send(&mut topics[topic], stamp, |bytes| bytes.extend_from_slice(&content)).expect("sent");
    }
    output.finish().expect("finished").publish().expect("published");
    fs::read(&path).expect("read")
}

fn by_the_crate() -> Vec<u8> {
    let options = WriteOptions::new().library("polhode").profile("").compression(Some(Compression::Zstd));
    let options = options.compression_threads(0).chunk_size(Some(1 << 20)).disable_seeking(true);
    let mut bytes = std::io::Cursor::new(Vec::new());
    let mut writer = options.create(&mut bytes).expect("begun");
    writer.write_metadata(&metadata()).expect("described");
    writer.attach(&attachment()).expect("attached");
    let channels = TOPICS.map(|topic| {
        let schema = writer.add_schema(SCHEMA.0, "protobuf", SCHEMA.1).expect("a schema");
        writer.add_channel(schema, topic, "protobuf", &BTreeMap::new()).expect("a channel")
    });
    let mut sequences = [0; TOPICS.len()];
    for (topic, time, content) in (0..MESSAGES).map(message) {
        let sequence = sequences[topic];
        let header = MessageHeader { channel_id: channels[topic], sequence, log_time: time, publish_time: time };
        writer.write_to_known_channel(&header, &content).expect("sent");
        sequences[topic] += 1;
    }
    writer.finish().expect("finished");
    drop(writer);
    bytes.into_inner()
}

/// Every record, as far as it does not depend on how well chunks were compressed.
fn records(bytes: &[u8]) -> Vec<String> {
    let records = mcap::read::LinearReader::new(bytes).expect("an .mcap");
    let records = records.map(|record| match record.expect("a record") {
        Record::Chunk { mut header, .. } => {
            header.compressed_size = 0;
            format!("{header:?}")
        }
        Record::ChunkIndex(mut index) => {
            (index.compressed_size, index.chunk_length, index.chunk_start_offset) = (0, 0, 0);
            index.message_index_offsets.values_mut().for_each(|offset| *offset = 0);
            format!("{index:?}")
        }
        Record::SummaryOffset(offset) => format!("{} {}", offset.group_opcode, offset.group_length),
        Record::DataEnd(_) => "data end".into(),
        Record::Footer(_) => "footer".into(),
        other => format!("{other:?}"),
    });
    records.collect()
}

#[test]
fn records_are_those_of_the_crate() {
    let (ours, theirs) = (by_polhode(), by_the_crate());
    let (ours, theirs) = (records(&ours), records(&theirs));
    assert_eq!(ours.iter().filter(|record| record.starts_with("ChunkHeader")).count(), 3, "three chunks");
    assert_eq!(ours.len(), theirs.len());
    for (ours, theirs) in ours.iter().zip(&theirs) {
        assert_eq!(ours, theirs);
    }
}

#[test]
fn checksums_and_places_are_right() {
    let bytes = by_polhode();
    let options = LinearReaderOptions::default()
        .with_validate_chunk_crcs(true)
        .with_validate_data_section_crc(true)
        .with_validate_summary_section_crc(true);
    let (mut reader, mut rest, mut messages) = (LinearReader::new_with_options(options), &bytes[..], 0);
    while let Some(event) = reader.next_event() {
        match event.expect("every checksum is right") {
            LinearReadEvent::ReadRequest(wanted) => {
                let read = rest.read(reader.insert(wanted)).expect("in memory");
                reader.notify_read(read);
            }
            LinearReadEvent::Record { opcode, .. } => messages += u64::from(opcode == op::MESSAGE),
        }
    }
    assert_eq!(messages, MESSAGES);
    let summary = mcap::Summary::read(&bytes).expect("a summary").expect("not empty");
    let in_chunk = |index: &ChunkIndex| {
        let indexed = summary.read_message_indexes(&bytes, index).expect("where the chunk's index says");
        let streamed = summary.stream_chunk(&bytes, index).expect("where its index says").count();
        assert_eq!(indexed.values().map(Vec::len).sum::<usize>(), streamed, "every message has an index");
        streamed as u64
    };
    assert_eq!(summary.chunk_indexes.iter().map(in_chunk).sum::<u64>(), MESSAGES);
    let found = mcap::read::attachment(&bytes, &summary.attachment_indexes[0]).expect("where its index says");
    assert_eq!(found, attachment());
    for record in mcap::read::LinearReader::new(&bytes).expect("an .mcap") {
        if let Record::SummaryOffset(offset) = record.expect("a record") {
            assert_eq!(bytes[usize::try_from(offset.group_start).expect("in memory")], offset.group_opcode);
        }
    }
}
