//! From recording to recording: every channel to the bit, and with the scene the very bytes of a run to that format.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::recording::{Conversion, Recorder, Recording, RecordingError};
use polhode::scenario::{Certificate, Plan, Scenario};
use polhode::telemetry::BodySamples;
use tempfile::tempdir;

/// Two bodies, one with a pulse, more than one batch.
const SCENE: &str = r#"
title = "A pair, one pushed"
summary = "Nothing to see"
duration_s = 9.0
sample_every_s = 0.001

[[body]]
name = "free"
principal_moments_kg_m2 = [1.0, 2.0, 2.6]
angular_velocity_rad_s = [0.7, -0.4, 1.1]

[[body]]
name = "pushed"
principal_moments_kg_m2 = [1.0, 2.0, 3.0]
angular_velocity_rad_s = [0.01, 5.0, 0.01]

[[body.torque.constant_body]]
moment_n_m = [0.0, 0.0, 0.2]
start_s = 3.3337
end_s = 4.1
"#;

fn scene(text: &str) -> Plan {
    let scenario = Scenario::parse(text, "pair.toml", &[]).expect("a scene");
    Plan::new(&Scenario { name: "pair".into(), ..scenario }).expect("a plan")
}

/// Runs `plan` to `pair.<extension>` of each format of this build.
fn run(plan: &Plan, folder: &Path) -> Vec<PathBuf> {
    let extensions = [
        #[cfg(feature = "mcap")]
        "mcap",
        #[cfg(feature = "rerun")]
        "rrd",
        "csv",
    ];
    let paths: Vec<_> = extensions.iter().map(|extension| folder.join(format!("pair.{extension}"))).collect();
    let mut recorder = Recorder::create(plan, &paths, false).expect("free names");
    let mut run = plan.start().expect("a motion");
    while let Some(samples) = run.next_batch().expect("finite states") {
        recorder.write(samples).expect("room");
    }
    recorder.finish().expect("room");
    paths
}

fn convert(from: &Path, folder: &Path, name: &str) -> (Conversion, PathBuf) {
    let conversion = Conversion::of(from).expect("whole");
    let path = folder.join(name);
    conversion.write(&[&path], false).expect("room");
    (conversion, path)
}

fn extension(path: &Path) -> &str {
    path.extension().and_then(|extension| extension.to_str()).expect("an extension")
}

/// All columns of all bodies and the times, as bits.
fn columns(path: &Path) -> Vec<Vec<u64>> {
    let mut recording = Recording::open(path).expect("whole");
    let mut all: Vec<Vec<u64>> = Vec::new();
    while let Some(samples) = recording.next_batch().expect("whole") {
        let columns = samples.bodies.iter().flat_map(BodySamples::columns);
        for (index, column) in std::iter::once(&samples.times_s).chain(columns).enumerate() {
            if all.len() == index {
                all.push(Vec::new());
            }
            all[index].extend(column.iter().map(|value| value.to_bits()));
        }
    }
    assert!(recording.is_whole());
    all
}

fn certified() -> Plan {
    let mut plan = scene(SCENE);
    for (body, attitude_rad) in plan.bodies.iter_mut().zip([Some(1.234_567e-15), None]) {
        body.certificate = Some(Certificate {
            attitude_rad,
            angular_velocity_relative: 2.0 / 3.0 * 1e-15,
            angular_momentum_relative: Some(0.0),
            position_m: None,
            worst_at_s: 1.0 / 3.0,
            covered_to_s: 9.0,
            is_whole: true,
            samples: 1000,
            method: "closed form".into(),
            reference: "Taylor series in double-double, = and \\ and\nlines".into(),
            reference_uncertainty: 1e-28,
        });
    }
    plan
}

#[test]
fn what_carries_its_scene_is_converted_to_the_bytes_of_a_run() {
    let folder = tempdir().expect("a folder");
    for (number, plan) in [scene(SCENE), certified()].iter().enumerate() {
        let inside = |name: &str| {
            let path = folder.path().join(format!("{number}{name}"));
            fs::create_dir(&path).expect("a free name");
            path
        };
        let recorded = run(plan, &inside("run"));
        for from in recorded.iter().filter(|path| extension(path) != "csv") {
            let target = inside(extension(from));
            for expected in &recorded {
                let (conversion, path) = convert(from, &target, &format!("other_name.{}", extension(expected)));
                assert_eq!(conversion.remark(), None);
                assert!(
                    fs::read(&path).expect("there") == fs::read(expected).expect("there"),
                    "{from:?} to {expected:?}"
                );
            }
        }
    }
}

#[cfg(all(feature = "mcap", feature = "rerun"))]
#[test]
fn every_scene_converts_to_the_bytes_of_its_run() {
    for name in polhode::scenario::library::names() {
        let folder = tempdir().expect("a folder");
        let plan = Plan::new(&Scenario::named(name, &[]).expect("a scene")).expect("a plan");
        let recorded = run(&plan, folder.path());
        for (from, to) in [(0, 1), (1, 0)] {
            let converted = format!("converted.{}", extension(&recorded[to]));
            let (conversion, path) = convert(&recorded[from], folder.path(), &converted);
            assert_eq!(conversion.remark(), None, "{name}");
            assert!(fs::read(&path).expect("there") == fs::read(&recorded[to]).expect("there"), "{name}: {converted}");
        }
    }
}

#[test]
fn listed_times_are_kept() {
    let folder = tempdir().expect("a folder");
    let times = "sample_times_s = [0.0, 0.3333333333333333, 0.5, 8.000000000000002]";
    let plan = scene(&SCENE.replace("sample_every_s = 0.001", times));
    let recorded = run(&plan, folder.path());
    for from in recorded.iter().filter(|path| extension(path) != "csv") {
        for expected in &recorded {
            let name = format!("{}.{}", extension(from), extension(expected));
            let (_, path) = convert(from, folder.path(), &name);
            assert!(fs::read(&path).expect("there") == fs::read(expected).expect("there"), "{from:?} to {expected:?}");
        }
    }
}

#[test]
fn without_a_scene_every_column_is_kept_and_where_it_comes_from_is_said() {
    let folder = tempdir().expect("a folder");
    let recorded = run(&scene(SCENE), folder.path());
    let csv = recorded.last().expect("a csv");
    for to in &recorded {
        let (conversion, path) = convert(csv, folder.path(), &format!("data.{}", extension(to)));
        assert_eq!(conversion.remark(), Some("it carries no scene"));
        assert_eq!(columns(&path), columns(csv));
        if extension(&path) == "csv" {
            assert!(fs::read(&path).expect("there") == fs::read(csv).expect("there"));
            continue;
        }
        let heading = Recording::open(&path).expect("whole").heading().clone();
        assert_eq!(heading.fact("converted_from"), Some("pair.csv"));
        assert_eq!(heading.planned_samples(), Some(9001));
        assert_eq!(heading.scene, None);
        let names: Vec<_> = heading.bodies.iter().map(|body| body.name.as_str()).collect();
        assert_eq!(names, ["free", "pushed"]);
        let (_, again) = convert(&path, folder.path(), &format!("again.{}", extension(to)));
        let heading = Recording::open(&again).expect("whole").heading().clone();
        let from = format!("data.{}, from pair.csv", extension(to));
        assert_eq!(heading.fact("converted_from"), Some(from.as_str()));
        assert_eq!(columns(&again), columns(csv));
    }
}

#[cfg(feature = "mcap")]
#[test]
fn a_scene_that_fits_brings_a_table_its_pictures() {
    let folder = tempdir().expect("a folder");
    let plan = scene(SCENE);
    let recorded = run(&plan, folder.path());
    let csv = recorded.last().expect("a csv");
    let conversion = Conversion::with_plan(csv, plan).expect("its scene");
    let path = folder.path().join("drawn.mcap");
    conversion.write(&[&path], false).expect("room");
    let topics = polhode::recording::contents(&path).expect("whole").entries;
    assert!(topics.iter().any(|topic| topic.name == "/tf") && topics.iter().any(|topic| topic.name == "/log"));
    let heading = Recording::open(&path).expect("whole").heading().clone();
    assert_eq!(heading.scene.as_deref(), Some(SCENE));
    assert_eq!(heading.fact("converted_from"), Some("pair.csv"));
    assert_eq!(columns(&path), columns(csv));
}

#[test]
fn a_scene_that_does_not_fit_is_refused() {
    let folder = tempdir().expect("a folder");
    let recorded = run(&scene(SCENE), folder.path());
    for (key, other, reason) in [
        ("[0.7, -0.4, 1.1]", "[0.7, -0.4, 1.2]", "of free at"),
        ("[0.0, 0.0, 0.2]", "[0.0, 0.0, 0.21]", "of pushed at"),
        ("duration_s = 9.0", "duration_s = 8.0", "the scene has 8001 samples from 0 to 8 s, the recording 9001"),
        ("name = \"free\"", "name = \"other\"", "the scene has a body other, the recording free"),
        ("duration_s = 9.0", "duration_s = 9.0\nchannels = [\"attitude\"]", "other channels of free"),
    ] {
        for from in &recorded {
            let refused = Conversion::with_plan(from, scene(&SCENE.replace(key, other))).expect_err("another scene");
            assert!(matches!(refused, RecordingError::OtherScene { .. }), "{refused}");
            let is_told = refused.to_string().contains(reason) || extension(from) != "csv";
            assert!(is_told, "{from:?}: {refused}");
        }
    }
}

#[cfg(feature = "mcap")]
#[test]
fn a_scene_that_is_refused_stops_no_data() {
    let folder = tempdir().expect("a folder");
    let mut plan = scene(SCENE);
    for (text, reason) in [
        ("unknown_key = 1\n", "its scene cannot be planned"),
        (&SCENE.replace("pushed", "pulled") as &str, "the scene has a body pulled, the recording pushed"),
        (&SCENE.replace("A pair", "Two") as &str, "title is \"A pair, one pushed\" in the recording"),
        (
            "duration_s = 1\nsample_every_s = 1\n[[body]]\n[[body.mesh]]\nfile = \"../box.stl\"\ndensity_kg_m3 = 1.0\n",
            "its scene cannot be planned",
        ),
        (
            "duration_s = 1\nsample_every_s = 1\n[[body]]\n[body.mesh]\nfile = \"../box.stl\"\ndensity_kg_m3 = 1.0\n",
            "its mesh ../box.stl is not beside the recording",
        ),
        (
            "duration_s = 1\nsample_every_s = 1\n[[body]]\nprincipal_moments_kg_m2 = [1, 2, 2.5]\n\
             [[body.torque.table]]\nframe = \"body\"\nfile = \"/etc/table.csv\"\n",
            "its table /etc/table.csv is not beside the recording",
        ),
    ] {
        plan.text = text.into();
        let inside = tempdir().expect("a folder");
        let recorded = run(&plan, inside.path());
        let (conversion, path) = convert(&recorded[0], folder.path(), &format!("{}.mcap", text.len()));
        assert!(conversion.plan().is_none());
        let remark = conversion.remark().expect("a reason");
        assert!(remark.contains(reason), "{remark}");
        assert_eq!(columns(&path), columns(&recorded[0]));
        assert_eq!(Recording::open(&path).expect("whole").heading().scene.as_deref(), Some(text), "kept for others");
    }
}

#[test]
fn what_is_not_whole_or_not_there_is_refused() {
    let folder = tempdir().expect("a folder");
    let recorded = run(&scene(SCENE), folder.path());
    for path in &recorded {
        let part = PathBuf::from(format!("{}.part", path.display()));
        let bytes = fs::read(path).expect("there");
        fs::write(&part, &bytes[..bytes.len() - 30]).expect("room");
        let refused = Conversion::of(&part).expect_err("its end is missing").to_string();
        assert!(refused.contains("polhode recover"), "{refused}");
        let conversion = Conversion::of(path).expect("whole");
        let taken = conversion.write(&[&path], false).expect_err("it is there");
        assert!(matches!(taken, RecordingError::Exists { .. }), "{taken}");
        conversion.write(&[&path], true).expect("over itself");
        assert!(fs::read(path).expect("there") == bytes || extension(path) == "csv");
    }
}
