//! Recordings have the same bytes everywhere: in one process and in several, for any thread count, folder, environment
//! and time of day, in debug and release.
//!
//! `tests/bits/recordings.txt` holds the SHA-256 of every scene's files, as `sha256sum` writes and checks them. Where a
//! change is meant, `POLHODE_BLESS=1 cargo test same_bytes` writes them anew; the changelog then names what changed.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use polhode::recording::{Recorder, Recording, contents};
use polhode::scenario::{Plan, Scenario, library};
use polhode::study::certify;
use polhode::telemetry::{BodySamples, Samples};
use sha2::{Digest, Sha256};
use tempfile::tempdir;

/// A line for each file of a folder, as `sha256sum` has it.
fn hashes(folder: &Path) -> Vec<String> {
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let line = |path: std::path::PathBuf| {
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
        (format!("{:x}  {name}", Sha256::digest(fs::read(&path).expect("a file"))), name)
    };
    let mut lines: Vec<_> = files.map(line).collect();
    lines.sort_by(|a, b| a.1.cmp(&b.1));
    lines.into_iter().map(|(line, _)| line).collect()
}

/// Fails with the names of the files (scene and format) that differ.
fn compare(expected: &[String], found: &[String], who: &str) {
    let named = |lines: &[String], others: &[String]| -> BTreeSet<String> {
        let differing = lines.iter().filter(|line| !others.contains(line));
        differing.filter_map(|line| Some(line.split_once("  ")?.1.to_owned())).collect()
    };
    let differing = &named(expected, found) | &named(found, expected);
    assert!(differing.is_empty(), "{who}: other bytes in {}", Vec::from_iter(differing).join(", "));
    assert_eq!(expected, found, "{who}");
}

/// Runs every scene to its end, by the built program, with `variables` and no others.
fn by_the_program(within: &Path, out: &str, variables: &[(&str, &str)]) -> Vec<String> {
    let output = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .current_dir(within)
        .env_clear()
        .envs(variables.iter().copied())
        .args(["run", "--all", "--quiet", "--format", "mcap,rrd,csv", "--out", out])
        .output()
        .expect("the program starts");
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    hashes(&within.join(out))
}

#[test]
fn every_scene_has_the_bytes_of_every_other_build() {
    let folder = tempdir().expect("a folder");
    let found = by_the_program(folder.path(), "out", &[]);
    assert_eq!(found.len(), 4 * library::names().count(), "three recordings and a layout each");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bits/recordings.txt");
    if env::var_os("POLHODE_BLESS").is_some() {
        fs::write(&file, found.join("\n") + "\n").expect("tests/bits can be written");
    }
    let kept: Vec<_> = fs::read_to_string(&file).expect("the hashes").lines().map(str::to_owned).collect();
    compare(&kept, &found, "kept and now");
}

#[test]
fn neither_threads_nor_folders_nor_the_environment_change_a_byte() {
    let folder = tempdir().expect("a folder");
    let plain = by_the_program(folder.path(), "out", &[("RAYON_NUM_THREADS", "1")]);
    let elsewhere = folder.path().join("Ünter dem Tisch");
    fs::create_dir(&elsewhere).expect("a folder");
    let settings: [(&str, &[(&str, &str)]); 3] = [
        ("a/b/c", &[("RAYON_NUM_THREADS", "2"), ("LANG", "tr_TR.UTF-8"), ("LC_ALL", "de_DE.UTF-8"), ("TZ", "UTC-14")]),
        ("../ö ut", &[("RAYON_NUM_THREADS", "5"), ("HOME", "/nowhere"), ("USER", "nobody"), ("TERM", "dumb")]),
        // Variables that Rerun's SDK obeys, and that say what time it is.
        (".", &[("RERUN", "off"), ("RERUN_FLUSH_NUM_BYTES", "1"), ("RUST_LOG", "off"), ("SOURCE_DATE_EPOCH", "1")]),
    ];
    for (out, variables) in settings {
        compare(&plain, &by_the_program(&elsewhere, out, variables), &format!("{out} {variables:?}"));
        // The next one's folder holds this one.
        if out == "a/b/c" {
            fs::remove_dir_all(elsewhere.join("a")).expect("a folder");
        }
    }
}

/// Records a scene in this process, in batches of its own.
fn here(plan: &Plan, folder: &Path, formats: &[&str], batch: usize) {
    let paths: Vec<_> = formats.iter().map(|format| folder.join(format!("{}.{format}", plan.name))).collect();
    let mut recorder = Recorder::create(plan, &paths, false).expect("free names");
    let mut run = plan.start().expect("a path");
    while let Some(samples) = run.next_batch().expect("a motion") {
        for first in (0..samples.len()).step_by(batch) {
            recorder.write(&part(samples, first, batch.min(samples.len() - first))).expect("room");
        }
    }
    recorder.finish().expect("free names");
}

fn part(samples: &Samples, first: usize, count: usize) -> Samples {
    let body = |body: &BodySamples| {
        let mut part = body.clone();
        for (part, column) in part.columns_mut().iter_mut().zip(body.columns()) {
            *part = column[first..first + count].to_vec();
        }
        part
    };
    Samples {
        first_index: samples.first_index + first as u64,
        times_s: samples.times_s[first..first + count].to_vec(),
        stamps_ns: samples.stamps_ns[first..first + count].to_vec(),
        bodies: samples.bodies.iter().map(body).collect(),
    }
}

fn plan(scene: &str, assignments: &[&str]) -> Plan {
    let assignments: Vec<_> = assignments.iter().map(|&assignment| assignment.to_owned()).collect();
    Plan::new(&Scenario::named(scene, &assignments).expect("a scene")).expect("a plan")
}

#[test]
fn one_process_writes_the_bytes_of_another_each_time() {
    let folders = [tempdir().expect("a folder"), tempdir().expect("a folder"), tempdir().expect("a folder")];
    for scene in library::names() {
        for folder in &folders[1..] {
            // As the program does, whose recordings say what checks have found.
            let plan = plan(scene, &[]).checked().expect("a motion");
            here(&plan, folder.path(), &["mcap", "rrd", "csv"], Plan::BATCH);
        }
    }
    let program = by_the_program(folders[0].path(), ".", &[]);
    let program: Vec<_> = program.into_iter().filter(|line| !line.contains(".layout.")).collect();
    for folder in &folders[1..] {
        compare(&program, &hashes(folder.path()), "the program and this process");
    }
}

#[test]
fn batches_leave_every_byte_of_mcap_and_csv() {
    for scene in ["thruster_pulses", "lagrange_top"] {
        let plan = plan(scene, &["duration_s=1.5"]);
        let recorded = [Plan::BATCH, 100, 1].map(|batch| {
            let folder = tempdir().expect("a folder");
            here(&plan, folder.path(), &["mcap", "csv"], batch);
            hashes(folder.path())
        });
        compare(&recorded[0], &recorded[1], "batches of 100");
        compare(&recorded[0], &recorded[2], "batches of 1");
    }
}

/// The id under which a viewer merges recordings.
fn id(plan: &Plan) -> String {
    let folder = tempdir().expect("a folder");
    here(plan, folder.path(), &["rrd"], Plan::BATCH);
    let details = contents(&folder.path().join(format!("{}.rrd", plan.name))).expect("a recording").details;
    details.into_iter().find(|(name, _)| name == "recording").expect("an id").1
}

/// The scene's hash in an `.mcap`.
fn scene_hash(plan: &Plan) -> String {
    let folder = tempdir().expect("a folder");
    here(plan, folder.path(), &["mcap"], Plan::BATCH);
    let recording = Recording::open(&folder.path().join(format!("{}.mcap", plan.name))).expect("a recording");
    let provenance = &recording.heading().provenance;
    provenance.iter().find(|(name, _)| name == "scene_sha256").expect("a hash").1.clone()
}

#[test]
fn equal_plans_have_equal_ids_and_others_have_others() {
    let short = "duration_s=0.5";
    let plain = plan("dzhanibekov", &[short]);
    assert_eq!(id(&plain), id(&plan("dzhanibekov", &[short])));
    assert_eq!(scene_hash(&plain), format!("{:x}", Sha256::digest(&plain.text)));
    let mut certified = plain.clone();
    for (body, certificate) in certified.bodies.iter_mut().zip(certify(&plain).expect("a reference")) {
        body.certificate = Some(certificate);
    }
    let others = [
        plan("dzhanibekov", &["duration_s=0.6"]),
        plan("dzhanibekov", &[short, "sample_every_s=0.02"]),
        plan("dzhanibekov", &[short, "channels=[\"attitude\"]"]),
        plan("dzhanibekov", &[short, "method=\"taylor\""]),
        plan("dzhanibekov", &[short, "title=\"Another\""]),
        plan("dzhanibekov", &[short, "body.0.angular_velocity_rad_s=[0.01, 5.0, 0.01000000000000001]"]),
        plan("dzhanibekov", &[short, "body.0.angular_velocity_rad_s=[0.01, 5.0, 0.01000000000000002]"]),
        plan("tennis_racket", &[short]),
        // Its recordings say more.
        certified,
    ];
    let ids: BTreeSet<_> = others.iter().map(id).chain([id(&plain)]).collect();
    assert_eq!(ids.len(), others.len() + 1, "two plans share an id: {ids:?}");
}
