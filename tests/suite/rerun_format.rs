//! `.rrd`: the same plan gives the same bytes, what is read back is what was recorded, damage is told and never a panic.

use std::fs;
use std::io::BufReader;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use polhode::recording::rerun_file::RerunFile;
use polhode::recording::{Contents, PartFile, Recording, RecordingError, Sink, Subject, contents};
use polhode::scenario::{Grid, Plan};
use polhode::telemetry::Channel;
use re_chunk::Chunk;
use re_log_types::{LogMsg, StoreKind};
use tempfile::tempdir;

use crate::planned::{assert_same_samples, bits, picture, plan, samples, single};

/// Records `plan` at `path` in batches of `batch`.
fn record(plan: &Plan, path: &Path, batch: usize) {
    let file = PartFile::create(path, false).expect("a free name");
    let mut sink = Box::new(RerunFile::create(&Subject::drawn(plan, &picture(plan)), file).expect("room"));
    for samples in samples(plan, batch) {
        sink.write(&samples).expect("room");
    }
    sink.finish().expect("room").publish().expect("a free name");
}

/// The bytes of `plan`, recorded.
fn recorded(plan: &Plan, batch: usize) -> Vec<u8> {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.rrd");
    record(plan, &path, batch);
    fs::read(path).expect("recorded")
}

/// All chunks of samples in the file at `path`.
fn chunks(path: &Path) -> Vec<Chunk> {
    let file = BufReader::new(fs::File::open(path).expect("recorded"));
    let messages = re_log_encoding::DecoderApp::decode_lazy(file).map(|message| message.expect("whole"));
    let batches = messages.filter_map(|message| match message {
        LogMsg::ArrowMsg(store, batch) if store.kind() == StoreKind::Recording => Some(batch),
        _ => None,
    });
    batches.map(|batch| Chunk::from_arrow_msg(&batch).expect("a chunk")).collect()
}

/// The rows of an entity that are not static: times in ns, and the numbers.
fn rows(chunks: &[Chunk], entity: &str) -> Vec<(i64, Vec<u64>)> {
    let mut rows = Vec::new();
    for chunk in chunks.iter().filter(|chunk| chunk.entity_path().to_string() == entity && !chunk.is_static()) {
        let (_, times) = chunk.timelines().iter().find(|(name, _)| name.as_str() == "sim_time").expect("stamped");
        let component = chunk.components_identifiers().next().expect("a component");
        let lists = chunk.iter_slices::<f64>(component);
        rows.extend(times.times_raw().iter().copied().zip(lists.map(|row| row.iter().map(|x| x.to_bits()).collect())));
    }
    rows
}

fn count(contents: &Contents, name: &str) -> Option<(u64, Option<f64>, Option<f64>)> {
    let entry = contents.entries.iter().find(|entry| entry.name == name)?;
    Some((entry.count, entry.from_s, entry.to_s))
}

#[test]
fn same_plan_same_bytes() {
    let plan = plan(3000);
    assert!(recorded(&plan, 1024) == recorded(&plan, 1024));
    let mut other = plan.clone();
    other.identity.push('#');
    assert!(recorded(&plan, 1024) != recorded(&other, 1024), "another scene, another recording id");
}

#[test]
fn samples_read_back_to_the_bit() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("pair.rrd");
    let plan = plan(2500);
    record(&plan, &path, 1024);
    let chunks = chunks(&path);
    let all = &samples(&plan, 2500)[0];
    for (planned, samples) in plan.bodies.iter().zip(&all.bodies) {
        let mut read: Vec<(i64, Vec<u64>)> = all.stamps_ns.iter().map(|stamp| (*stamp, Vec::new())).collect();
        for channel in samples.channels() {
            let of_channel = rows(&chunks, &format!("/body/{}/plots/{}", planned.name, channel.row().name));
            assert_eq!(of_channel.len(), read.len());
            for (row, (stamp, numbers)) in read.iter_mut().zip(of_channel) {
                assert_eq!(row.0, stamp);
                row.1.extend(numbers);
            }
        }
        assert!(read.iter().enumerate().all(|(index, (_, numbers))| *numbers == bits(samples, index)));
    }
}

/// The footer tells of every chunk and is made in memory: long recordings have long chunks.
#[test]
fn chunks_of_a_long_recording_are_longer_and_none_is_lost_where_it_is_given_up() {
    let folder = tempdir().expect("a folder");
    let (plan, count) = (single(30_000), |path: &Path| {
        let mut recording = Recording::open(path).expect("samples");
        let mut batches = Vec::new();
        while let Some(samples) = recording.next_batch().expect("sound") {
            batches.push(samples.len());
        }
        batches
    });
    let picture = picture(&plan);
    let mut subject = Subject::drawn(&plan, &picture);
    subject.sampling.samples = 5_000_000;
    for is_given_up in [false, true] {
        let path = folder.path().join("run.rrd");
        let file = PartFile::create(&path, true).expect("a free name");
        let mut sink = Box::new(RerunFile::create(&subject, file).expect("room"));
        for samples in samples(&plan, 8192) {
            sink.write(&samples).expect("room");
        }
        let path = if is_given_up {
            drop(sink);
            folder.path().join("run.rrd.part")
        } else {
            sink.finish().expect("room").publish().expect("a free name");
            path
        };
        assert_eq!(count(&path), [16384, 30_000 - 16384], "given up: {is_given_up}");
    }
}

#[test]
fn a_recording_gives_back_what_was_recorded() {
    let folder = tempdir().expect("a folder");
    let mut listed = single(3);
    listed.grid = Grid::List(vec![0.0, 1.0 / 3.0, 1e3 + f64::EPSILON * 1024.0]);
    for (number, plan) in [plan(5000), listed].into_iter().enumerate() {
        let path = folder.path().join(format!("{number}.rrd"));
        record(&plan, &path, 1024);
        let recording = Recording::open(&path).expect("whole");
        for (read, planned) in recording.heading().bodies.iter().zip(&plan.bodies) {
            assert_eq!((&read.name, &read.channels), (&planned.name, &planned.channels));
        }
        assert_same_samples(recording, &plan);
    }
}

#[test]
fn times_read_back_to_the_bit() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("list.rrd");
    let mut plan = single(3);
    let times = [0.0, 1.0 / 3.0, 1e3 + f64::EPSILON * 1024.0];
    plan.grid = Grid::List(times.to_vec());
    record(&plan, &path, 2);
    let read: Vec<_> = rows(&chunks(&path), "/time/time_s").into_iter().map(|(_, numbers)| numbers).collect();
    assert_eq!(read, times.map(|time| vec![time.to_bits()]));
}

#[test]
fn contents_count_every_entity() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("pair.rrd");
    record(&plan(5002), &path, 4096);
    let contents = contents(&path).expect("whole");
    assert_eq!(contents.format, "rrd");
    assert_eq!(count(&contents, "/body/upper/plots/attitude"), Some((5002, Some(0.0), Some(5.001))));
    assert_eq!(count(&contents, "/body/lower/plots/angular_velocity"), Some((5002, Some(0.0), Some(5.001))));
    assert_eq!(count(&contents, "/world/body/upper"), Some((1252, Some(0.0), Some(5.001))));
    assert_eq!(count(&contents, "/world/vectors/upper/moment"), Some((1252, Some(0.0), Some(5.001))));
    assert_eq!(count(&contents, "/poinsot/upper/energy_ellipsoid"), Some((1252, Some(0.0), Some(5.001))));
    assert_eq!(count(&contents, "/body_frame/upper/angular_momentum"), Some((1252, Some(0.0), Some(5.001))));
    assert_eq!(count(&contents, "/time/interval_s"), Some((1, None, None)));
    assert_eq!(count(&contents, "/log"), Some((2, Some(0.0), Some(2.5e-3))));
    assert!(contents.details.contains(&("application".into(), "polhode-pair".into())));
}

#[test]
fn only_watched_channels_are_written() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("lower.rrd");
    let mut plan = plan(100);
    plan.bodies.remove(0);
    plan.events.clear();
    record(&plan, &path, 100);
    let contents = contents(&path).expect("whole");
    let moving: Vec<_> = contents.entries.iter().filter(|entry| entry.from_s.is_some()).collect();
    let names: Vec<_> = moving.iter().map(|entry| entry.name.as_str()).collect();
    assert_eq!(names, ["/body/lower/plots/angular_velocity", "/body/lower/plots/rotational_energy", "/zero"]);
}

#[test]
fn a_body_at_rest_has_no_arrow() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("rest.rrd");
    let plan = single(8);
    let mut samples = samples(&plan, 8).remove(0);
    for column in samples.bodies[0].channel_mut(Channel::MomentWorld).expect("watched") {
        column.fill(0.0);
    }
    let file = PartFile::create(&path, false).expect("a free name");
    let mut sink = Box::new(RerunFile::create(&Subject::drawn(&plan, &picture(&plan)), file).expect("room"));
    sink.write(&samples).expect("room");
    sink.finish().expect("room").publish().expect("a free name");
    let arrows = chunks(&path);
    let moving =
        |chunk: &&Chunk| chunk.entity_path().to_string() == "/world/vectors/upper/moment" && !chunk.is_static();
    let arrows = arrows.iter().find(moving).expect("logged");
    assert_eq!(arrows.num_rows(), 3, "every fourth sample and the last");
    let is_empty = |row: Option<_>| row.is_some_and(|list: re_chunk::external::arrow::array::ArrayRef| list.is_empty());
    assert!(arrows.components().list_arrays().all(|lists| lists.iter().all(is_empty)));
}

#[test]
fn a_cut_off_file_is_refused_and_its_part_is_read_as_far_as_it_goes() {
    let folder = tempdir().expect("a folder");
    let (path, part) = (folder.path().join("cut.rrd"), folder.path().join("cut.rrd.part"));
    let whole = recorded(&single(100), 50);
    for length in (0..whole.len()).step_by(1009) {
        fs::write(&path, &whole[..length]).expect("room");
        assert!(matches!(contents(&path), Err(RecordingError::Decode { .. })), "{length} bytes");
        fs::write(&part, &whole[..length]).expect("room");
        assert_eq!(contents(&part).is_ok(), length >= 12, "{length} bytes");
    }
    let mut longer = whole;
    longer.push(0);
    fs::write(&path, &longer).expect("room");
    assert!(matches!(contents(&path), Err(RecordingError::Decode { .. })));
}

#[test]
fn a_damaged_file_never_panics() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("damaged.rrd");
    let whole = recorded(&single(20), 20);
    let (mut refused, mut tried) = (0_usize, 0_usize);
    for position in (0..whole.len()).step_by(1009) {
        let mut damaged = whole.clone();
        damaged[position] ^= 1 << (position % 8);
        fs::write(&path, &damaged).expect("room");
        let outcome = catch_unwind(AssertUnwindSafe(|| contents(&path)));
        let outcome = outcome.unwrap_or_else(|_| panic!("panicked on bit {} of byte {position}", position % 8));
        tried += 1;
        refused += usize::from(outcome.is_err());
    }
    // Numbers and words carry no check sum; everything else does or has a form.
    assert!(refused * 10 > tried, "{refused} of {tried} refused");
}
