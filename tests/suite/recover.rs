//! What a killed run left becomes a whole recording, with every sample that was there.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::recording::{PartFile, Recorder, Recording, RecordingError, contents, recover};
use polhode::scenario::{Plan, Scenario};
use polhode::telemetry::BodySamples;
use tempfile::tempdir;

/// A pulse that begins at 2 s and ends at 8 s, in the second batch of samples.
const SCENE: &str = r#"
title = "A push"
duration_s = 9.0
sample_every_s = 0.0001

[[body]]
principal_moments_kg_m2 = [1.0, 2.0, 3.0]
angular_velocity_rad_s = [0.01, 5.0, 0.01]

[[body.torque.constant_body]]
moment_n_m = [0.0, 0.0, 0.2]
start_s = 0.5
end_s = 8.0
"#;

const FORMATS: &[&str] = &[
    #[cfg(feature = "mcap")]
    "mcap",
    #[cfg(feature = "rerun")]
    "rrd",
    "csv",
];

fn plan() -> Plan {
    let scenario = Scenario::parse(SCENE, "push.toml", &[]).expect("a scene");
    Plan::new(&Scenario { name: "push".into(), ..scenario }).expect("a plan")
}

/// Runs `batches` batches of `plan`, and then no more; or all of it, to its names.
fn run(plan: &Plan, folder: &Path, batches: usize) -> Vec<PathBuf> {
    let paths: Vec<_> = FORMATS.iter().map(|extension| folder.join(format!("push.{extension}"))).collect();
    let mut recorder = Recorder::create(plan, &paths, false).expect("free names");
    let mut run = plan.start().expect("a motion");
    for _ in 0..batches {
        let Some(samples) = run.next_batch().expect("finite states") else {
            recorder.finish().expect("room");
            return paths;
        };
        recorder.write(samples).expect("room");
    }
    paths
}

fn part_of(path: &Path) -> PathBuf {
    PathBuf::from(format!("{}.part", path.display()))
}

/// All numbers of each sample, time first, as bits.
fn rows(path: &Path) -> Vec<Vec<u64>> {
    let mut recording = Recording::open(path).expect("a recording");
    let mut rows = Vec::new();
    while let Some(samples) = recording.next_batch().expect("sound") {
        for index in 0..samples.len() {
            let columns = samples.bodies.iter().flat_map(BodySamples::columns);
            let columns = std::iter::once(&samples.times_s).chain(columns);
            rows.push(columns.map(|column| column[index].to_bits()).collect());
        }
    }
    rows
}

fn is_csv(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "csv")
}

#[test]
fn a_part_becomes_a_whole_recording_of_the_first_samples() {
    let folder = tempdir().expect("a folder");
    let plan = plan();
    let whole = tempdir().expect("a folder");
    let expected = rows(&run(&plan, whole.path(), usize::MAX)[0]);
    assert_eq!(expected.len(), 90_001);
    for path in run(&plan, folder.path(), 3) {
        let recovered = recover(&part_of(&path), None, false).expect("samples");
        let kept = usize::try_from(recovered.conversion.survey().samples).expect("few");
        assert_eq!(recovered.file.path, path);
        assert_eq!(
            (recovered.conversion.remark().is_none(), recovered.planned.is_none()),
            (!is_csv(&path), is_csv(&path))
        );
        assert!(!part_of(&path).exists() && recovered.part.is_none(), "it is in the recording now");
        assert_eq!(kept, 3 * 8192);
        assert_eq!(rows(&path), expected[..kept]);
        let inside = contents(&path).expect("whole");
        if is_csv(&path) {
            continue;
        }
        let survey = inside.survey.expect("columns");
        assert!(survey.is_whole);
        let told = survey.heading.fact("recovered").expect("said");
        assert_eq!(told, "the first 24576 of 90001 samples, to 2.4575 s");
        assert_eq!(survey.heading.planned_samples(), Some(24_576));
        let log = inside.entries.iter().find(|entry| entry.name == "/log").expect("events");
        assert_eq!(log.to_s, Some(0.5), "what comes later did not happen");
        assert!(inside.entries.iter().all(|entry| entry.to_s.is_none_or(|end| end <= 2.4575)));
    }
}

#[cfg(all(feature = "mcap", feature = "rerun"))]
#[test]
fn what_was_recovered_converts_like_any_other() {
    let folder = tempdir().expect("a folder");
    let paths = run(&plan(), folder.path(), 2);
    for path in &paths[..2] {
        recover(&part_of(path), None, false).expect("samples");
    }
    for (from, to, name) in [(0, 1, "other.rrd"), (1, 0, "other.mcap")] {
        let conversion = polhode::recording::Conversion::of(&paths[from]).expect("whole");
        assert_eq!(conversion.remark(), None);
        let name = folder.path().join(name);
        conversion.write(&[&name], false).expect("room");
        assert!(fs::read(&name).expect("there") == fs::read(&paths[to]).expect("there"), "{name:?}");
    }
}

#[test]
fn cut_anywhere_it_is_recovered_or_said_to_be_empty() {
    let folder = tempdir().expect("a folder");
    let plan = plan();
    for path in run(&plan, folder.path(), usize::MAX) {
        let (bytes, expected, part) = (fs::read(&path).expect("there"), rows(&path), part_of(&path));
        let mut most = 0;
        for length in (0..=8).map(|eighth| bytes.len() * eighth / 8) {
            fs::write(&part, &bytes[..length]).expect("room");
            match recover(&part, None, true) {
                Ok(recovered) => {
                    let kept = usize::try_from(recovered.conversion.survey().samples).expect("few");
                    assert!(kept >= most && rows(&path) == expected[..kept], "{length} bytes of {path:?}");
                    most = kept;
                }
                Err(RecordingError::NothingKept { .. } | RecordingError::Decode { .. }) => assert_eq!(most, 0),
                Err(error) => panic!("{length} bytes of {path:?}: {error}"),
            }
        }
        assert_eq!(most, expected.len());
        assert!(fs::read(&path).expect("there") == bytes, "nothing was missing: it is what the run gave");
    }
}

#[test]
fn another_format_leaves_the_part() {
    let folder = tempdir().expect("a folder");
    let path = &run(&plan(), folder.path(), 1)[0];
    let table = folder.path().join("table.csv");
    let recovered = recover(&part_of(path), Some(&table), false).expect("samples");
    assert_eq!(recovered.part.is_some(), !is_csv(path));
    assert_eq!(part_of(path).exists(), !is_csv(path), "a table does not hold all that a part does");
    assert_eq!(rows(&table).len(), 8192);
}

#[test]
fn what_is_being_written_or_there_already_is_refused() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("push.csv");
    let running = PartFile::create(&path, false).expect("a free name");
    let refused = recover(&part_of(&path), None, false).expect_err("a run goes on").to_string();
    assert!(refused.contains("another run is writing it"), "{refused}");
    drop(running);
    fs::write(part_of(&path), "time_s,total_energy_j\n").expect("room");
    let empty = recover(&part_of(&path), None, false).expect_err("no sample");
    assert!(matches!(empty, RecordingError::NothingKept { .. }), "{empty}");
    fs::write(part_of(&path), "time_s,total_energy_j\n0.0,1.0\n0.5,1").expect("room");
    fs::write(&path, "precious").expect("room");
    let refused = recover(&part_of(&path), None, false).expect_err("it is there");
    assert!(matches!(refused, RecordingError::Exists { .. }), "{refused}");
    assert_eq!(fs::read_to_string(&path).expect("there"), "precious");
    assert!(part_of(&path).exists());
    recover(&part_of(&path), None, true).expect("asked for");
    assert_eq!(fs::read_to_string(&path).expect("there"), "time_s,total_energy_j\n0.0,1.0\n");
    let refused = recover(&path, None, false).expect_err("no part").to_string();
    assert!(refused.contains("ends in .part"), "{refused}");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1, "nothing else is left");
}
