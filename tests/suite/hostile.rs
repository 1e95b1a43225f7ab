//! Files that lie: cut, damaged, out of order, claiming to be huge, or another program's. An error each time, never a panic,
//! and no memory by a length that the file only claims. What `.mcap` files do is in `faults`.

use std::fs;
use std::path::Path;

use polhode::recording::csv_file::CsvFile;
use polhode::recording::{PartFile, Recording, RecordingError, Sink, Subject, contents};
use polhode::telemetry::Samples;
use tempfile::tempdir;

use crate::planned::{bits, samples, single};

/// Reads all there is: how many samples, and whether the end was there. What comes must be what was recorded.
fn read(path: &Path, expected: &Samples) -> Result<(usize, bool), RecordingError> {
    let mut recording = Recording::open(path)?;
    let mut count = 0;
    while let Some(batch) = recording.next_batch()? {
        for index in 0..batch.len() {
            assert_eq!(batch.times_s[index].to_bits(), expected.times_s[count].to_bits(), "sample {count}");
            assert_eq!(bits(&batch.bodies[0], index), bits(&expected.bodies[0], count), "sample {count}");
            count += 1;
        }
    }
    Ok((count, recording.is_whole()))
}

/// Reads all there is, whatever it says.
fn survives(path: &Path) -> bool {
    let columns = Recording::open(path).and_then(|mut recording| {
        while recording.next_batch()?.is_some() {}
        Ok(())
    });
    let parts = contents(path);
    columns.is_ok() && parts.is_ok()
}

fn table() -> (Vec<u8>, Samples) {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let plan = single(5);
    let samples = samples(&plan, 5).remove(0);
    let file = PartFile::create(&path, false).expect("a free name");
    let mut sink = Box::new(CsvFile::create(&Subject::of(&plan), file).expect("room"));
    sink.write(&samples).expect("room");
    sink.finish().expect("room").publish().expect("a free name");
    (fs::read(path).expect("recorded"), samples)
}

#[test]
fn a_table_cut_anywhere_gives_whole_lines_or_an_error() {
    let folder = tempdir().expect("a folder");
    let [whole, part] = ["cut.csv", "cut.csv.part"].map(|name| folder.path().join(name));
    let (bytes, expected) = table();
    for length in 0..bytes.len() {
        fs::write(&whole, &bytes[..length]).expect("room");
        fs::write(&part, &bytes[..length]).expect("room");
        let lines = bytes[..length].split(|byte| *byte == b'\n').count() - 1;
        let ends_with_line = bytes[..length].last() == Some(&b'\n');
        match read(&whole, &expected) {
            Ok(found) => assert_eq!((found, ends_with_line), ((lines - 1, true), true), "cut after {length}"),
            Err(error) => assert!(!ends_with_line, "cut after {length}: {error}"),
        }
        match read(&part, &expected) {
            Ok(found) => assert_eq!(found, (lines - 1, false), "cut after {length}"),
            Err(error) => assert_eq!(lines, 0, "cut after {length}: {error}"),
        }
    }
}

#[test]
fn a_table_damaged_anywhere_is_no_panic() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("bad.csv");
    let (bytes, _) = table();
    let (mut refused, mut tried) = (0, 0);
    for (place, damage) in (0..bytes.len()).step_by(3).zip([0x01, 0x10, 0x80, 0xff].into_iter().cycle()) {
        let mut bytes = bytes.clone();
        bytes[place] ^= damage;
        fs::write(&path, &bytes).expect("room");
        tried += 1;
        refused += usize::from(!survives(&path));
    }
    // A digit for a digit is a number still: there is no checksum.
    assert!(2 * refused > tried, "{refused} of {tried} refused");
}

#[test]
fn tables_of_unending_lines_and_bodies_are_refused() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("long.csv");
    let refusal = |text: &[u8]| {
        fs::write(&path, text).expect("room");
        read(&path, &Samples::default()).expect_err("no recording").to_string()
    };
    let endless = [&b"time_s,"[..], &vec![b'a'; 1 << 24]].concat();
    assert!(refusal(&endless).contains("line 1 has more than 16 MiB"));
    let endless = [&b"time_s,total_energy_j\n0,"[..], &vec![b'1'; 1 << 24]].concat();
    assert!(refusal(&endless).contains("line 2 has more than 16 MiB"));
    let crowd: Vec<String> = (0..70_000).map(|number| format!("{number}.total_energy_j")).collect();
    assert!(refusal(format!("time_s,{}\n", crowd.join(",")).as_bytes()).contains("more than 65535 bodies"));
    for other in ["", "\n", "\u{feff}time_s,total_energy_j\n", "x;y\n1;2\n", "time_s\n\"0\"\n"] {
        refusal(other.as_bytes());
    }
}

#[cfg(feature = "rerun")]
mod rrd {
    use polhode::recording::rerun_file::RerunFile;
    use polhode::telemetry::Channel;
    use re_log_encoding::{Compression, Decodable as _, Encodable as _};
    use re_protos::log_msg::v1alpha1::ArrowMsg;

    use super::*;
    use crate::planned::picture;

    const HEADER: usize = 12;
    /// Kind and length.
    const MESSAGE: usize = 16;

    fn recorded() -> (Vec<u8>, Samples) {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join("run.rrd");
        let mut plan = single(40);
        plan.bodies[0].channels = vec![Channel::Attitude, Channel::AngularVelocity, Channel::TotalEnergy];
        let file = PartFile::create(&path, false).expect("a free name");
        let mut sink = Box::new(RerunFile::create(&Subject::drawn(&plan, &picture(&plan)), file).expect("room"));
        for samples in samples(&plan, 20) {
            sink.write(&samples).expect("room");
        }
        sink.finish().expect("room").publish().expect("a free name");
        (fs::read(path).expect("recorded"), samples(&plan, 40).remove(0))
    }

    /// Where each message begins, and the end of the last.
    fn boundaries(bytes: &[u8]) -> Vec<usize> {
        let mut places = vec![HEADER];
        let mut place = HEADER;
        while bytes[place] != 0 {
            place += MESSAGE + length_at(bytes, place);
            places.push(place);
        }
        places
    }

    fn length_at(bytes: &[u8], message: usize) -> usize {
        let length = bytes[message + 8..message + 16].try_into().expect("eight bytes");
        usize::try_from(u64::from_le_bytes(length)).expect("in memory")
    }

    /// The chunks of samples: where each begins and ends, and its entity's channel.
    fn chunks(bytes: &[u8]) -> Vec<(usize, usize)> {
        let places = boundaries(bytes);
        let spans = places.windows(2).map(|pair| (pair[0], pair[1]));
        let holds = |bytes: &[u8], word: &[u8]| bytes.windows(word.len()).any(|window| window == word);
        let is_column = |(start, end): &(usize, usize)| {
            holds(&bytes[*start..*end], b"/plots/") && holds(&bytes[*start..*end], b"sim_time")
        };
        spans.filter(is_column).collect()
    }

    #[test]
    fn cut_anywhere_it_gives_true_samples_or_an_error() {
        let folder = tempdir().expect("a folder");
        let [whole, part] = ["cut.rrd", "cut.rrd.part"].map(|name| folder.path().join(name));
        let (bytes, expected) = recorded();
        let boundaries = boundaries(&bytes);
        assert!(boundaries.len() > 50 && chunks(&bytes).len() == 6, "{}", boundaries.len());
        let near = boundaries.iter().flat_map(|place| [place - 1, *place, place + 1, place + MESSAGE]);
        let ends = near.chain((0..bytes.len()).step_by(997)).chain(bytes.len() - 40..bytes.len());
        for length in ends.filter(|length| *length < bytes.len()) {
            fs::write(&whole, &bytes[..length]).expect("room");
            let refused = read(&whole, &expected);
            assert!(matches!(refused, Err(RecordingError::Decode { .. })), "{length}: {refused:?}");
            fs::write(&part, &bytes[..length]).expect("room");
            if let Ok((count, is_whole)) = read(&part, &expected) {
                assert!(!is_whole && [0, 20, 40].contains(&count), "{length}: {count}");
            }
        }
        fs::write(&part, &bytes).expect("room");
        assert_eq!(read(&part, &expected).expect("whole"), (40, true));
    }

    #[test]
    fn damaged_anywhere_it_is_no_panic() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join("bad.rrd.part");
        let (bytes, _) = recorded();
        let heads = boundaries(&bytes).into_iter().flat_map(|place| (place..place + MESSAGE).step_by(5));
        let columns = chunks(&bytes).into_iter().flat_map(|(start, end)| (start..end).step_by(41));
        for (place, damage) in heads.chain(columns).zip([0x01, 0x80, 0x10, 0xff].into_iter().cycle()) {
            let mut bytes = bytes.clone();
            if let Some(byte) = bytes.get_mut(place) {
                *byte ^= damage;
            }
            fs::write(&path, &bytes).expect("room");
            survives(&path);
        }
    }

    #[test]
    fn lengths_that_are_only_claimed_are_refused() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join("bomb.rrd");
        let (bytes, expected) = recorded();
        let refusal = |bytes: &[u8]| {
            fs::write(&path, bytes).expect("room");
            let refused = read(&path, &expected).expect_err("a bomb");
            assert!(matches!(refused, RecordingError::Decode { .. }), "{refused}");
            refused.to_string()
        };
        let (start, end) = chunks(&bytes)[0];
        for claimed in [u64::MAX, 1 << 62, 1 << 40, bytes.len() as u64] {
            let mut bytes = bytes.clone();
            bytes[start + 8..start + 16].copy_from_slice(&claimed.to_le_bytes());
            assert!(refusal(&bytes).contains("cut off"), "{claimed}");
        }
        let packed = ArrowMsg::from_rrd_bytes(&bytes[start + MESSAGE..end]).expect("a chunk");
        for claimed in [u64::MAX, 1 << 40, 1 << 29, packed.payload.len() as u64 * 255 + 1] {
            let mut chunk = packed.clone();
            chunk.set_compression(Compression::LZ4.into());
            chunk.uncompressed_size = claimed;
            let mut payload = Vec::new();
            chunk.to_rrd_bytes(&mut payload).expect("room");
            let message = [&bytes[start..start + 8], &(payload.len() as u64).to_le_bytes(), &payload].concat();
            let bytes = [&bytes[..start], &message, &bytes[end..]].concat();
            assert!(refusal(&bytes).contains("a chunk that claims"), "{claimed}");
        }
    }

    #[test]
    fn columns_out_of_turn_are_refused() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join("order.rrd.part");
        let (bytes, expected) = recorded();
        let chunks = chunks(&bytes);
        let message = |number: usize| &bytes[chunks[number].0..chunks[number].1];
        let ends = |number: usize| (&bytes[..chunks[number].0], &bytes[chunks[number].1..]);
        let (before, after) = ends(0);
        let (before_last, after_last) = ends(5);
        for (case, bytes) in [
            ("a channel is missing", [before, after].concat()),
            ("a channel is there twice", [before, message(0), message(0), after].concat()),
            ("two channels are swapped", [before, message(1), message(0), &bytes[chunks[1].1..]].concat()),
            ("a batch comes again", [before_last, message(2), after_last].concat()),
            ("batches are swapped", [before, message(3), after].concat()),
        ] {
            fs::write(&path, bytes).expect("room");
            let refused = read(&path, &expected).map(|found| panic!("{case}: {found:?}")).expect_err("out of turn");
            assert!(matches!(refused, RecordingError::Decode { .. }), "{case}: {refused}");
        }
    }

    #[test]
    fn another_programs_file_is_looked_into_but_not_read() {
        let folder = tempdir().expect("a folder");
        let path = folder.path().join("other.rrd.part");
        let (bytes, _) = recorded();
        // The stores and the layout: what comes before the first words about a body.
        let word = b"/scene";
        let words = boundaries(&bytes)
            .windows(2)
            .map(|pair| (pair[0], pair[1]))
            .find(|(start, end)| bytes[*start..*end].windows(word.len()).any(|window| window == word));
        fs::write(&path, &bytes[..words.expect("the scene's text").0]).expect("room");
        let refused = Recording::open(&path).expect_err("no columns").to_string();
        assert!(refused.contains("no recording of this program"), "{refused}");
        assert!(contents(&path).expect("an rrd").survey.is_none());
        for other in [&b""[..], b"RRF2", b"\x89MCAP0\r\n", b"time_s,total_energy_j\n", &[0; 4096]] {
            fs::write(&path, other).expect("room");
            assert!(matches!(Recording::open(&path), Err(RecordingError::Decode { .. })), "{other:?}");
        }
    }
}
