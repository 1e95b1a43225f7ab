//! A disk that is full after any byte: an error that names the file, no recording, and a part file that is true as far
//! as it goes.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use polhode::recording::{PartFile, Recording};
use polhode::scenario::Plan;
use tempfile::tempdir;

use crate::faults::{Open, formats, record};
use crate::planned::{bits, plan, samples, single};

/// A whole recording of `plan`.
fn whole(plan: &Plan, open: Open, path: &Path) -> Vec<u8> {
    record(plan, open, PartFile::create(path, true).expect("a name")).expect("room");
    let bytes = fs::read(path).expect("recorded");
    fs::remove_file(path).expect("recorded");
    bytes
}

fn part_of(path: &Path) -> PathBuf {
    path.with_added_extension("part")
}

/// How many samples a part file gives back: each is what was recorded. None of a file without a heading.
fn true_samples(part: &Path, plan: &Plan) -> usize {
    let Ok(mut recording) = Recording::open(part) else { return 0 };
    let count = usize::try_from(plan.grid.len()).expect("a short plan");
    let expected = &samples(plan, count)[0];
    let mut read = 0;
    while let Some(batch) = recording.next_batch().expect("a part is read as far as it goes") {
        for index in 0..batch.len() {
            assert_eq!(batch.times_s[index].to_bits(), expected.times_s[read].to_bits());
            for (found, written) in batch.bodies.iter().zip(&expected.bodies) {
                assert_eq!(bits(found, index), bits(written, read), "sample {read}");
            }
            read += 1;
        }
    }
    read
}

/// Records with room for so many bytes, which must be an error, and says how many samples the part file holds.
fn on_a_full_disk(plan: &Plan, open: Open, path: &Path, room: u64) -> usize {
    let file = PartFile::create(path, true).expect("a name").with_room_for(room);
    let error = record(plan, open, file).expect_err("a full disk").to_string();
    let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
    assert!(error.contains("no room left") && error.contains(name), "room for {room}: {error}");
    assert!(!path.exists(), "room for {room}: a broken recording has its name");
    let part = part_of(path);
    // An empty part file is removed.
    let kept = fs::metadata(&part).map_or(0, |file| file.len());
    assert_eq!(kept, room, "what there was room for is on the disk");
    if kept == 0 { 0 } else { true_samples(&part, plan) }
}

#[cfg(any(feature = "mcap", feature = "rerun"))]
fn number(bytes: &[u8], range: std::ops::Range<usize>) -> usize {
    let mut number = [0; 8];
    number.copy_from_slice(&bytes[range]);
    usize::try_from(u64::from_le_bytes(number)).expect("a short file")
}

/// Where each record of an `.mcap` begins (opcode, length, content), and where its summary does.
#[cfg(feature = "mcap")]
fn mcap_records(bytes: &[u8]) -> (Vec<usize>, usize) {
    let (mut records, mut place, mut summary) = (Vec::new(), 8, 0);
    while place + 9 < bytes.len() {
        records.push(place);
        // Data end: what follows is the summary.
        if bytes[place] == 15 {
            summary = place;
        }
        place += 9 + number(bytes, place + 1..place + 9);
    }
    (records, summary)
}

/// Where each message of an `.rrd` begins (kind, length, content), and where its footer does.
#[cfg(feature = "rerun")]
fn rrd_messages(bytes: &[u8]) -> (Vec<usize>, usize) {
    let (mut messages, mut place) = (Vec::new(), 12);
    let mut footer = 0;
    while number(bytes, place..place + 8) != 0 {
        messages.push(place);
        place += 16 + number(bytes, place + 8..place + 16);
        footer = place;
    }
    (messages, footer)
}

#[test]
fn a_csv_may_be_cut_at_any_byte() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let (plan, open) = (single(3), formats()[0].1);
    let bytes = whole(&plan, open, &path);
    for room in 0..bytes.len() {
        let lines = bytes[..room].split(|byte| *byte == b'\n').count() - 1;
        let read = on_a_full_disk(&plan, open, &path, room as u64);
        assert_eq!(read, lines.saturating_sub(1), "room for {room}: every whole line is there");
    }
}

#[cfg(feature = "mcap")]
#[test]
fn an_mcap_may_be_cut_at_any_boundary_and_anywhere_in_its_summary() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.mcap");
    let (plan, (_, open)) = (single(3), formats()[1]);
    let bytes = whole(&plan, open, &path);
    let (records, summary) = mcap_records(&bytes);
    assert!(records.len() > 10 && summary > 0);
    for room in 0..bytes.len() {
        let read = on_a_full_disk(&plan, open, &path, room as u64);
        assert!(room < summary || read == 3, "room for {room}: all samples are before the summary");
    }
    // Several chunks.
    let plan = crate::planned::plan(12_000);
    let bytes = whole(&plan, open, &path);
    let (records, _) = mcap_records(&bytes);
    let chunks: Vec<_> = records.into_iter().filter(|place| bytes[*place] == 6).collect();
    assert!(chunks.len() > 3, "{chunks:?}");
    let mut before = 0;
    for place in chunks {
        let read = on_a_full_disk(&plan, open, &path, place as u64);
        assert!(read >= before, "a longer file holds no fewer samples");
        before = read;
        on_a_full_disk(&plan, open, &path, place as u64 + 1);
    }
    assert!(before > 6000, "{before}");
}

#[cfg(feature = "rerun")]
#[test]
fn an_rrd_may_be_cut_at_any_boundary_and_all_over_its_footer() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.rrd");
    let (_, open) = formats()[formats().len() - 1];
    let mut plan = single(3);
    plan.bodies[0].channels.truncate(1);
    let bytes = whole(&plan, open, &path);
    let (messages, footer) = rrd_messages(&bytes);
    assert!(messages.len() > 20 && footer > 0);
    // The footer is one write of some 70 kB: every byte at its ends, and many between.
    let around = messages.iter().flat_map(|place| [place - 1, *place, place + 1]);
    let (first, last) = (footer + 50, bytes.len() - 50);
    for room in around.chain(footer..first).chain((first..last).step_by(257)).chain(last..bytes.len()) {
        let read = on_a_full_disk(&plan, open, &path, room as u64);
        assert!(room < footer || read == 3, "room for {room}: all samples are before the footer");
    }
}

/// What a killed run loses is at most what it wrote within the flushing interval and the batch that it was writing; of
/// an `.mcap` besides, the samples of the chunk that is not closed.
#[test]
fn each_batch_is_on_disk_when_its_flush_was_due() {
    let plan = plan(6000);
    for (extension, open) in formats() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join(format!("run.{extension}"));
        let file = PartFile::create(&path, false).expect("a free name").flushing_every(Duration::ZERO);
        let mut sink = open(&plan, file).expect("room");
        let mut written = 0;
        for samples in samples(&plan, 512) {
            sink.write(&samples).expect("room");
            written += samples.len();
            let kept = true_samples(&part_of(&path), &plan);
            // A chunk of an .mcap is 1 MiB; a sample of this plan takes more than 300 bytes of it.
            let open_chunk = if extension == "mcap" { (1 << 20) / 300 } else { 0 };
            assert!(kept <= written && kept + open_chunk >= written, "{extension}: {kept} of {written}");
        }
    }
}
