//! Cut and damaged files, failed writes, taken names: an error each time, never a panic, never a broken recording under a
//! final name. Full disks are in `full_disks`; what the program does, in `killed_runs` and `contested_names`.

use std::fs;
use std::io::Write;
use std::path::Path;

use polhode::recording::csv_file::CsvFile;
use polhode::recording::{PartFile, Recorder, RecordingError, Sink, Subject, contents};
use polhode::scenario::Plan;
use tempfile::tempdir;

use crate::planned::{plan, samples, single};

/// Opens a sink on a file.
pub type Open = fn(&Plan, PartFile) -> Result<Box<dyn Sink>, RecordingError>;

/// Every format of this build, `csv` first.
pub fn formats() -> Vec<(&'static str, Open)> {
    let csv: Open = |plan, file| Ok(Box::new(CsvFile::create(&Subject::of(plan), file)?));
    #[cfg(feature = "mcap")]
    let mcap: Open = |plan, file| {
        let picture = crate::planned::picture(plan);
        Ok(Box::new(polhode::recording::mcap_file::McapFile::create(&Subject::drawn(plan, &picture), file)?))
    };
    #[cfg(feature = "rerun")]
    let rrd: Open = |plan, file| {
        let picture = crate::planned::picture(plan);
        Ok(Box::new(polhode::recording::rerun_file::RerunFile::create(&Subject::drawn(plan, &picture), file)?))
    };
    vec![
        ("csv", csv),
        #[cfg(feature = "mcap")]
        ("mcap", mcap),
        #[cfg(feature = "rerun")]
        ("rrd", rrd),
    ]
}

/// A whole run.
pub fn record(plan: &Plan, open: Open, file: PartFile) -> Result<(), RecordingError> {
    let mut sink = open(plan, file)?;
    for samples in samples(plan, 512) {
        sink.write(&samples)?;
    }
    sink.finish()?.publish()
}

#[test]
fn after_a_failure_every_call_fails() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let mut file = PartFile::create(&path, false).expect("a free name").with_room_for(3);
    file.write_all(b"12345").expect("buffered");
    file.flush().expect_err("no room");
    let mut file = file.with_room_for(1000);
    let error = file.write_all(b"678").expect_err("a hole in the file").to_string();
    assert!(error.contains("an earlier write failed"), "{error}");
    file.publish().expect_err("a hole in the file");
    assert!(!path.exists());
}

#[test]
fn a_run_cut_short_leaves_what_it_has() {
    let plan = plan(12_000);
    for (extension, open) in formats() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join(format!("run.{extension}"));
        let mut sink = open(&plan, PartFile::create(&path, false).expect("a free name")).expect("room");
        for samples in samples(&plan, 512).iter().take(10) {
            sink.write(samples).expect("room");
        }
        drop(sink);
        assert!(!path.exists());
        let part = folder.path().join(format!("run.{extension}.part"));
        let kept = contents(&part).expect("readable");
        assert!(kept.entries.iter().any(|entry| entry.count == 5120), "{kept:?}");
    }
}

#[test]
fn what_exists_is_not_overwritten_unless_asked() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let (short, long) = (single(10), single(20));
    let run = |plan: &Plan, overwrite| -> Result<(), RecordingError> {
        let mut recorder = Recorder::create(plan, &[&path], overwrite)?;
        recorder.write(&samples(plan, 100)[0])?;
        recorder.finish().map(drop)
    };
    run(&short, false).expect("a free name");
    assert!(matches!(run(&long, false), Err(RecordingError::Exists { path: found }) if found == path));
    assert_eq!(contents(&path).expect("untouched").entries[0].count, 10);
    run(&long, true).expect("overwriting");
    assert_eq!(contents(&path).expect("replaced").entries[0].count, 20);
}

#[test]
fn a_name_taken_during_the_run_is_not_overwritten() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let mut file = PartFile::create(&path, false).expect("a free name");
    file.write_all(b"new").expect("buffered");
    fs::write(&path, "old").expect("room");
    assert!(matches!(file.publish(), Err(RecordingError::Exists { .. })));
    assert_eq!(fs::read_to_string(&path).expect("untouched"), "old");
    assert_eq!(fs::read_to_string(folder.path().join("run.csv.part")).expect("kept"), "new");
}

#[test]
fn two_runs_into_one_name_are_refused() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let mut first = PartFile::create(&path, true).expect("a free name");
    let error = PartFile::create(&path, true).expect_err("being written").to_string();
    assert!(error.contains("another run is writing it"), "{error}");
    first.write_all(b"first").expect("buffered");
    first.publish().expect("a free name");
    assert_eq!(fs::read_to_string(&path).expect("published"), "first");
}

#[test]
fn what_a_killed_run_left_is_replaced_only_when_asked() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let part = folder.path().join("run.csv.part");
    fs::write(&part, "").expect("room");
    drop(PartFile::create(&path, false).expect("an empty leftover is nothing"));
    assert!(!part.exists());
    fs::write(&part, "an hour of work").expect("room");
    assert!(matches!(PartFile::create(&path, false), Err(RecordingError::Exists { path }) if path == part));
    assert_eq!(fs::read_to_string(&part).expect("kept"), "an hour of work");
    PartFile::create(&path, true).expect("asked for");
}

#[test]
fn one_refusal_leaves_no_file_at_all() {
    let folder = tempdir().expect("a folder");
    let plan = single(10);
    let [fine, taken] = ["fine.csv", "taken.csv"].map(|name| folder.path().join(name));
    fs::write(&taken, "").expect("room");
    assert!(Recorder::create(&plan, &[&fine, &taken], false).is_err());
    assert!(Recorder::create(&plan, &[&fine, &fine], false).is_err());
    assert!(Recorder::create(&plan, &[fine.as_path(), Path::new("run.bag")], false).is_err());
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
}

#[cfg(not(feature = "mcap"))]
#[test]
fn a_format_that_is_left_out_says_so() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.mcap");
    let refused = Recorder::create(&single(10), &[&path], false).err().expect("left out");
    assert!(matches!(refused, RecordingError::FormatAbsent { feature: "mcap", .. }), "{refused}");
    assert!(matches!(contents(&path), Err(RecordingError::FormatAbsent { .. })));
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}

#[cfg(feature = "mcap")]
mod damaged_mcap {
    use polhode::recording::Recording;

    use super::*;
    use crate::planned::bits;

    fn recorded(folder: &Path) -> Vec<u8> {
        let path = folder.join("run.mcap");
        let (_, open) = formats()[1];
        record(&single(40), open, PartFile::create(&path, false).expect("a free name")).expect("room");
        fs::read(&path).expect("recorded")
    }

    #[test]
    fn cut_anywhere_it_is_refused_and_as_a_part_it_is_read() {
        let folder = tempdir().expect("a folder");
        let bytes = recorded(folder.path());
        let [whole, part] = ["cut.mcap", "cut.mcap.part"].map(|name| folder.path().join(name));
        let ends = (0..70).chain(bytes.len() - 70..bytes.len());
        for length in ends.chain((70..bytes.len() - 70).step_by(37)) {
            fs::write(&whole, &bytes[..length]).expect("room");
            let refused = contents(&whole);
            assert!(matches!(refused, Err(RecordingError::Decode { .. })), "{length}: {refused:?}");
            fs::write(&part, &bytes[..length]).expect("room");
            let read = contents(&part).unwrap_or_else(|error| panic!("cut after {length} bytes: {error}"));
            assert!(read.details.iter().any(|(_, state)| state.starts_with("unfinished")), "{length}");
        }
    }

    #[test]
    fn damage_anywhere_is_refused_and_never_read_as_truth() {
        let folder = tempdir().expect("a folder");
        let plan = single(40);
        let bytes = recorded(folder.path());
        let [whole, part] = ["bad.mcap", "bad.mcap.part"].map(|name| folder.path().join(name));
        for (place, damage) in (0..bytes.len()).step_by(11).zip([0x01, 0x80, 0xff].into_iter().cycle()) {
            let mut bytes = bytes.clone();
            bytes[place] ^= damage;
            fs::write(&whole, &bytes).expect("room");
            assert!(contents(&whole).is_err(), "byte {place} of {}: every byte is under a checksum", bytes.len());
            fs::write(&part, &bytes).expect("room");
            only_true_samples(&part, &plan);
        }
    }

    /// What is read of a damaged file before the damage shows is what was recorded.
    fn only_true_samples(path: &Path, plan: &Plan) {
        let Ok(mut recording) = Recording::open(path) else { return };
        let expected = &samples(plan, 40)[0];
        while let Ok(Some(batch)) = recording.next_batch() {
            for index in 0..batch.len() {
                assert_eq!(bits(&batch.bodies[0], index), bits(&expected.bodies[0], index));
            }
        }
    }

    /// A file of one chunk that says it unpacks to `unpacked` bytes and of `content`, packed.
    fn with_chunk(unpacked: u64, content: &[u8]) -> Vec<u8> {
        let packed = zstd::bulk::compress(content, 1).expect("room");
        let mut chunk = [&[0; 16][..], &unpacked.to_le_bytes(), &crc32fast::hash(content).to_le_bytes()].concat();
        chunk.extend([&[4, 0, 0, 0][..], b"zstd", &(packed.len() as u64).to_le_bytes(), &packed].concat());
        let header = [&[1, 8, 0, 0, 0, 0, 0, 0, 0][..], &[0; 8]].concat();
        [&b"\x89MCAP0\r\n"[..], &header, &[6], &(chunk.len() as u64).to_le_bytes(), &chunk].concat()
    }

    #[test]
    fn what_claims_to_be_huge_is_refused_before_it_is_unpacked() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join("bomb.mcap.part");
        let zeros = vec![0; 1 << 22];
        let mut long = with_chunk(8, &[0; 8]);
        long[26..34].copy_from_slice(&(1_u64 << 60).to_le_bytes());
        for bytes in [with_chunk(1 << 40, &zeros), with_chunk(u64::MAX, &zeros), with_chunk(1 << 10, &zeros), long] {
            fs::write(&path, bytes).expect("room");
            let refused = Recording::open(&path).expect_err("a bomb");
            assert!(matches!(refused, RecordingError::Decode { .. }), "{refused}");
            assert!(refused.to_string().contains("bomb.mcap.part"), "{refused}");
        }
    }

    /// An `.mcap` of one topic, by another writer.
    fn foreign(path: &Path, topic: &str, schema: &str) -> Result<Recording, RecordingError> {
        let mut writer =
            mcap::Writer::new(std::io::BufWriter::new(fs::File::create(path).expect("room"))).expect("begun");
        let schema = writer.add_schema(schema, "protobuf", b"another description").expect("a schema");
        writer.add_channel(schema, topic, "protobuf", &std::collections::BTreeMap::new()).expect("a topic");
        writer.finish().expect("room");
        drop(writer);
        Recording::open(path)
    }

    #[test]
    fn another_schema_is_refused() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join("foreign.mcap");
        for (topic, schema, rule) in [
            ("/body/a/state", "polhode.BodyState", "not the polhode.BodyState that this version knows"),
            ("/body/a/state", "other.State", "not the polhode.BodyState that this version knows"),
            ("/state", "polhode.BodyState", "states are on /body/<name>/state"),
            ("/tf", "foxglove.FrameTransforms", "no topic of polhode.BodyState"),
        ] {
            let refused = foreign(&path, topic, schema).expect_err("no recording").to_string();
            assert!(refused.contains(rule) && refused.contains("foreign.mcap"), "{refused}");
        }
    }
}
