//! The built program, killed without a word: nothing broken under a final name, and what was flushed can be read.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use polhode::recording::{Recording, RecordingError, contents};
use polhode::scenario::{Plan, Scenario};
use polhode::telemetry::{BodySamples, Samples};

use crate::contested_names::{SCENE, folder};

const FORMATS: [&str; 3] = ["mcap", "rrd", "csv"];

fn start(folder: &Path, flags: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_polhode"))
        .current_dir(folder)
        .args(["run", "scene.toml", "--quiet", "--out", ".", "--format", "mcap,rrd,csv"])
        .args(flags)
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

fn kill(mut run: Child) {
    run.kill().expect("it is ours");
    run.wait().expect("it ends");
}

fn final_name(folder: &Path, format: &str) -> PathBuf {
    folder.join(format!("scene.{format}"))
}

fn part_name(folder: &Path, format: &str) -> PathBuf {
    folder.join(format!("scene.{format}.part"))
}

/// Waits until something has come to be, while the run goes on.
fn wait_until(run: &mut Child, what: impl Fn() -> bool) {
    while !what() {
        assert!(run.try_wait().expect("it is ours").is_none(), "the run ended before it could be killed");
        std::thread::yield_now();
    }
}

fn size(path: &Path) -> u64 {
    fs::metadata(path).map_or(0, |file| file.len())
}

/// Every column of every body, after the times.
fn append(columns: &mut Vec<Vec<f64>>, samples: &Samples) {
    let bodies = samples.bodies.iter().flat_map(BodySamples::columns);
    let read: Vec<_> = std::iter::once(&samples.times_s).chain(bodies).collect();
    columns.resize_with(read.len(), Vec::new);
    for (column, read) in columns.iter_mut().zip(read) {
        column.extend(read);
    }
}

/// Reads a file to its end: how many samples it holds, each of which is what the run of `plan` finds, and whether it is
/// whole.
fn true_samples(path: &Path, plan: &Plan) -> Result<(usize, bool), RecordingError> {
    let mut recording = Recording::open(path)?;
    let (mut read, mut expected) = (Vec::new(), Vec::new());
    while let Some(samples) = recording.next_batch()? {
        append(&mut read, samples);
    }
    let count = read.first().map_or(0, Vec::len);
    let mut run = plan.start().expect("a path");
    while expected.first().map_or(0, Vec::len) < count {
        append(&mut expected, run.next_batch().expect("a motion").expect("no more samples than planned"));
    }
    for (read, expected) in read.iter().zip(&expected) {
        let is_same = read.iter().zip(expected).all(|(read, expected)| read.to_bits() == expected.to_bits());
        assert!(is_same, "{}: other numbers than the run's", path.display());
    }
    Ok((count, recording.is_whole()))
}

fn plan(assignments: &[&str]) -> Plan {
    let assignments: Vec<_> = assignments.iter().map(|&assignment| assignment.to_owned()).collect();
    Plan::new(&Scenario::parse(SCENE, "scene.toml", &assignments).expect("a scene")).expect("a plan")
}

/// Every file of the folder that a run of `plan` left: those that have their names are whole.
fn assert_nothing_is_broken(folder: &Path, plan: &Plan) {
    for format in FORMATS {
        let (whole, part) = (final_name(folder, format), part_name(folder, format));
        if whole.exists() {
            let samples = true_samples(&whole, plan).expect("under its final name a file is whole");
            assert_eq!(samples, (usize::try_from(plan.grid.len()).expect("a short run"), true), "{format}");
        }
        if size(&part) > 1000 {
            // It can be read as far as it goes, if that is as far as its first sample.
            if let Err(error) = true_samples(&part, plan) {
                assert!(error.to_string().contains("or none of its start"), "{error}");
            }
        }
    }
}

#[test]
fn killed_while_it_writes_a_run_leaves_all_that_was_flushed() {
    // Much more than is written before the run is killed: four million samples.
    let endless = ["--duration", "4e3"];
    let plan = plan(&["duration_s=4e3"]);
    // A chunk of an .mcap, a batch of an .rrd, and as much again; a batch has 8192 samples.
    for (format, bytes, samples) in [
        ("mcap", 1, 0),
        ("rrd", 1, 0),
        ("csv", 1, 0),
        ("csv", 1 << 20, 2000),
        ("mcap", 1 << 20, 2000),
        ("rrd", 1 << 22, 8192),
        ("mcap", 5 << 20, 16384),
    ] {
        let folder = folder();
        let mut run = start(folder.path(), &endless);
        wait_until(&mut run, || size(&part_name(folder.path(), format)) >= bytes);
        kill(run);
        for other in FORMATS {
            assert!(!final_name(folder.path(), other).exists(), "{other} after {bytes} bytes of {format}");
        }
        assert!(!folder.path().join("scene.layout.json").exists(), "after {bytes} bytes of {format}");
        assert_nothing_is_broken(folder.path(), &plan);
        if samples > 0 {
            let part = part_name(folder.path(), format);
            let (kept, is_whole) = true_samples(&part, &plan).expect("readable");
            assert!(kept >= samples && !is_whole, "{format}: {kept} samples in {} bytes", size(&part));
        }
    }
}

#[test]
fn killed_while_it_ends_a_run_leaves_no_name_on_a_broken_file() {
    let plan = plan(&[]);
    // As soon as this is there: the last part, then one name after the other, while the others are still parts.
    let moments = ["csv.part", "mcap", "rrd", "csv"];
    for moment in moments.iter().cycle().take(4 * moments.len()) {
        let folder = folder();
        let mut run = start(folder.path(), &[]);
        while !folder.path().join(format!("scene.{moment}")).exists() && run.try_wait().expect("ours").is_none() {
            std::thread::yield_now();
        }
        kill(run);
        assert_nothing_is_broken(folder.path(), &plan);
        // The next run says what is in its way, and with --force needs nothing cleared away.
        let again = start(folder.path(), &["--force"]).wait().expect("it ends");
        assert_eq!(again.code(), Some(0), "killed when {moment} was there");
        assert_nothing_is_broken(folder.path(), &plan);
        let left = fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(left, 5, "the scene, three recordings and a layout; no parts");
    }
}

/// A run that is killed between giving a file its name and taking the other from it.
#[test]
fn a_file_under_both_its_names_is_whole_and_is_parted_by_force() {
    let folder = folder();
    assert_eq!(start(folder.path(), &[]).wait().expect("it ends").code(), Some(0));
    for format in FORMATS {
        fs::hard_link(final_name(folder.path(), format), part_name(folder.path(), format)).expect("a second name");
    }
    assert_nothing_is_broken(folder.path(), &plan(&[]));
    assert_eq!(start(folder.path(), &[]).wait().expect("it ends").code(), Some(2));
    assert_nothing_is_broken(folder.path(), &plan(&[]));
    assert_eq!(start(folder.path(), &["--force"]).wait().expect("it ends").code(), Some(0));
    assert_nothing_is_broken(folder.path(), &plan(&[]));
    assert!(FORMATS.iter().all(|format| !part_name(folder.path(), format).exists()));
}

/// A run that is killed between naming its first file and its second leaves the second whole, as a part.
#[test]
fn a_part_that_only_lacks_its_name_is_told_to_be_complete() {
    let folder = folder();
    assert_eq!(start(folder.path(), &[]).wait().expect("it ends").code(), Some(0));
    let plan = plan(&[]);
    for format in ["mcap", "rrd"] {
        let part = part_name(folder.path(), format);
        fs::rename(final_name(folder.path(), format), &part).expect("renamed back");
        let state = |path: &Path| -> String {
            let details = contents(path).expect("readable").details;
            details.into_iter().find(|(name, _)| name == "state").expect("a state").1
        };
        assert_eq!(state(&part), "complete");
        assert_eq!(true_samples(&part, &plan).expect("readable"), (1001, true), "{format}");
        let bytes = fs::read(&part).expect("a file");
        fs::write(&part, &bytes[..bytes.len() - 1]).expect("room");
        assert_eq!(state(&part), "unfinished: the end is missing", "{format}");
    }
}
