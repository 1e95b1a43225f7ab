//! The goldens of this repository, and the command that holds and writes them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use polhode::recording::Recording;
use polhode::scenario::library;
use serde_json::Value;
use tempfile::TempDir;

use crate::cli::{SCENE, folder_with, polhode, stderr, stdout};

/// Fifty scenes and their goldens are to stay a small clone. A cloud with each of its particles is the largest.
const MOST_BYTES: u64 = 210_000;
const MOST_BYTES_IN_ALL: u64 = 6_000_000;

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{error}: {}", stderr(output)))
}

#[test]
fn every_golden_is_what_its_scene_gives_in_every_byte() {
    let output = polhode(repository(), &["golden", "--check"]);
    assert_eq!(output.status.code(), Some(0), "\n{}{}", stdout(&output), stderr(&output));
}

#[test]
fn goldens_are_small() {
    let files = fs::read_dir(repository().join("recordings/golden")).expect("the goldens");
    let goldens: Vec<PathBuf> = files.map(|entry| entry.expect("an entry").path()).collect();
    let size = |path: &PathBuf| fs::metadata(path).expect("a file").len();
    for golden in &goldens {
        assert!(size(golden) <= MOST_BYTES, "{}: {} bytes", golden.display(), size(golden));
    }
    assert!(goldens.iter().map(size).sum::<u64>() <= MOST_BYTES_IN_ALL);
    assert_eq!(goldens.len(), 2 * library::names().count(), "one of each format for every scene, and nothing else");
}

/// The newest section that says `Golden values: sha256:…` says it last of the values that are there.
#[test]
fn the_changelog_names_the_values_of_the_goldens() {
    let found = json(&polhode(repository(), &["golden", "--json"]));
    let values = found["values_sha256"].as_str().expect("goldens that can be read");
    let changelog = fs::read_to_string(repository().join("CHANGELOG.md")).expect("the changelog");
    let told = changelog.split("\n## ").find_map(|section| {
        section.lines().filter_map(|line| line.trim().strip_prefix("- Golden values: sha256:")).next_back()
    });
    assert_eq!(
        told,
        Some(values),
        "a value of the goldens changed: say in CHANGELOG.md what changed and why, and below it\n- Golden values: \
         sha256:{values}\n"
    );
}

/// A folder with a scene of its own, and goldens of it in `goldens`.
fn blessed() -> TempDir {
    let folder = folder_with(SCENE);
    let output = golden(folder.path(), &["--bless"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    folder
}

fn golden(folder: &Path, more: &[&str]) -> Output {
    polhode(folder, &[&["golden", "--folder", "goldens", "--scenes-in", "."], more].concat())
}

/// How each golden stands, by file name.
fn standings(folder: &Path, more: &[&str]) -> (Option<i32>, Vec<(String, String)>) {
    let output = golden(folder, &[more, &["--json"]].concat());
    let found = json(&output);
    let standing = |golden: &Value| {
        let file = Path::new(golden["file"].as_str().expect("a path")).file_name().expect("a name");
        (file.to_string_lossy().into_owned(), golden["standing"].as_str().expect("a word").to_owned())
    };
    let goldens = found["goldens"].as_array().expect("a list");
    (output.status.code(), goldens.iter().map(standing).collect())
}

fn told(standings: &[(&str, &str)]) -> Vec<(String, String)> {
    standings.iter().map(|(file, standing)| ((*file).to_owned(), (*standing).to_owned())).collect()
}

#[test]
fn bless_writes_and_check_holds() {
    let folder = folder_with(SCENE);
    let none = golden(folder.path(), &["--check"]);
    assert_eq!(none.status.code(), Some(2));
    assert!(stderr(&none).contains("there are no goldens in goldens: `--bless` writes them"), "{}", stderr(&none));
    let written = golden(folder.path(), &["--bless"]);
    assert_eq!((written.status.code(), stderr(&written).as_str()), (Some(0), ""));
    for words in ["scene.mcap  missing", "scene.rrd   missing", "2 of 2 goldens written", "golden values: sha256:"] {
        assert!(stdout(&written).contains(words), "{}", stdout(&written));
    }
    let bytes = fs::read(folder.path().join("goldens/scene.rrd")).expect("a golden");
    for arguments in [&["--check"][..], &[], &["--bless"], &["--values"]] {
        let held = golden(folder.path(), arguments);
        assert_eq!(held.status.code(), Some(0), "{}", stderr(&held));
        assert!(stdout(&held).starts_with("2 goldens, "), "{}", stdout(&held));
        assert!(stdout(&held).contains("the same in every byte"), "{}", stdout(&held));
    }
    assert_eq!(fs::read(folder.path().join("goldens/scene.rrd")).expect("a golden"), bytes);
    assert_eq!(fs::read_dir(folder.path().join("goldens")).expect("goldens").count(), 2, "and nothing beside them");
}

#[test]
fn a_golden_converts_to_the_very_run_that_it_is_of() {
    // 101 samples are too many for a golden of 15 columns: it has every second.
    let folder = folder_with(&SCENE.replace("sample_every_s = 0.1", "sample_every_s = 0.01"));
    let folder = folder.path();
    assert_eq!(golden(folder, &["--bless"]).status.code(), Some(0));
    let run =
        polhode(folder, &["run", "scene.toml", "--format", "mcap,rrd", "--out", "runs", "--sample-every", "0.02"]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    for golden in ["goldens/scene.mcap", "goldens/scene.rrd"] {
        let converted = polhode(folder, &["convert", golden, "a.mcap", "a.rrd", "--force"]);
        assert_eq!((converted.status.code(), stderr(&converted).as_str()), (Some(0), ""));
        for format in ["mcap", "rrd"] {
            let read = |name: &str| fs::read(folder.join(format!("{name}.{format}"))).expect("a recording");
            assert!(read("a") == read("runs/scene"), "{golden} to {format}");
        }
    }
}

#[test]
fn what_changed_is_said_with_its_size() {
    let folder = blessed();
    let faster = SCENE.replace("[0.0, 0.0, 3.0]", "[0.0, 0.0, 3.0000000000000004]");
    fs::write(folder.path().join("scene.toml"), faster).expect("room");
    let output = golden(folder.path(), &[]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let said = stdout(&output);
    let line = said.lines().find(|line| line.trim().starts_with("body  angular_velocity ")).expect(&said);
    let words: Vec<_> = line.split_whitespace().collect();
    assert_eq!(words[2..6], ["11", "of", "11", "1"], "one unit in the last place of ω at every sample: {line}");
    assert_eq!(words[8..], ["0", "s", "z", "=", "3.0", "3.0000000000000004"], "when, and what it was and is: {line}");
    assert!(said.contains("\nscene.mcap, scene.rrd:\n"), "told once for both: {said}");
    assert!(said.contains("where that is meant: polhode golden --bless --folder goldens --scenes-in .\n"), "{said}");
    let found = json(&golden(folder.path(), &["--json"]));
    assert_eq!(found["is_same"], false);
    let of_rates = |change: &&Value| change["channel"] == "angular_velocity";
    let changes = found["goldens"][1]["changes"].as_array().expect("a list");
    let change = changes.iter().find(of_rates).expect("a change of ω");
    assert_eq!((&change["most_ulps"], &change["samples"], &change["first_s"]), (&1.into(), &11.into(), &0.0.into()));
    let written = golden(folder.path(), &["--bless"]);
    assert_eq!(written.status.code(), Some(0));
    assert!(stdout(&written).contains("values changed: the changelog is to name"), "{}", stdout(&written));
    assert_eq!(standings(folder.path(), &[]).0, Some(0));
}

#[test]
fn other_words_are_other_bytes_of_the_same_values() {
    let folder = blessed();
    fs::write(folder.path().join("scene.toml"), SCENE.replace("that stays", "that goes on")).expect("room");
    let both = told(&[("scene.mcap", "other bytes"), ("scene.rrd", "other bytes")]);
    assert_eq!(standings(folder.path(), &[]), (Some(1), both.clone()));
    assert_eq!(standings(folder.path(), &["--values"]), (Some(0), both), "where only values count");
    let written = stdout(&golden(folder.path(), &["--bless"]));
    assert!(written.contains("every value is the same"), "{written}");
    assert!(written.contains("title says A spin that goes on, said A spin that stays"), "{written}");
    assert!(!written.contains("values changed"), "{written}");
}

#[test]
fn what_is_damaged_missing_or_left_over_fails() {
    let folder = blessed();
    let golden_at = |name: &str| folder.path().join("goldens").join(name);
    let mut bytes = fs::read(golden_at("scene.rrd")).expect("a golden");
    bytes.truncate(bytes.len() - 10);
    fs::write(golden_at("scene.rrd"), &bytes).expect("room");
    fs::remove_file(golden_at("scene.mcap")).expect("a golden");
    let expected = told(&[("scene.mcap", "missing"), ("scene.rrd", "unreadable")]);
    assert_eq!(standings(folder.path(), &[]), (Some(1), expected.clone()));
    assert_eq!(standings(folder.path(), &["--values"]), (Some(1), expected));
    assert_eq!(golden(folder.path(), &["--bless"]).status.code(), Some(0));
    assert_eq!(standings(folder.path(), &[]).0, Some(0), "both are whole again");

    fs::rename(folder.path().join("scene.toml"), folder.path().join("renamed.toml")).expect("a scene");
    let output = golden(folder.path(), &[]);
    assert_eq!(output.status.code(), Some(1));
    let said = stdout(&output);
    for words in ["renamed.mcap  missing", "renamed.rrd   missing", "to be removed", "goldens/scene.rrd"] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let blessed = golden(folder.path(), &["--bless"]);
    assert_eq!(blessed.status.code(), Some(1), "what no scene makes is not removed by a program");
    assert!(golden_at("scene.rrd").exists() && golden_at("renamed.rrd").exists());
    let one = polhode(folder.path(), &["golden", "--folder", "goldens", "renamed.toml"]);
    assert_eq!(one.status.code(), Some(0), "of a scene that is named, only its goldens are looked at");
}

#[test]
fn what_cannot_be_done_is_said() {
    let folder = blessed();
    let folder = folder.path();
    for (arguments, words) in [
        (&["no_such_scene"][..], "no scene is called \"no_such_scene\""),
        (&["absent.toml"], "cannot read the scene absent.toml"),
        (&["scene.toml", "./scene.toml"], "two scenes are called \"scene\""),
        (&["--scenes-in", "goldens"], "there is no scene in goldens"),
        (&["--scenes-in", "absent"], "cannot read the folder absent"),
        (&["--check", "--bless"], "cannot be used with"),
    ] {
        let output = polhode(folder, &[&["golden", "--folder", "goldens"], arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stdout(&output));
        assert!(stderr(&output).contains(words), "{arguments:?}: {}", stderr(&output));
    }
    fs::write(folder.join("file"), "").expect("room");
    let output = polhode(folder, &["golden", "--bless", "--folder", "file", "scene.toml"]);
    assert_eq!(output.status.code(), Some(2), "a folder that cannot be made");
    fs::write(folder.join("scene.toml"), "duration_s = -1").expect("room");
    assert_eq!(golden(folder, &["--bless"]).status.code(), Some(2), "a scene that is refused");
    assert!(folder.join("goldens/scene.mcap").exists());
}

/// A table is a golden too, for those who build without the formats of viewers.
#[test]
fn goldens_have_the_formats_that_are_asked_for() {
    let folder = folder_with(SCENE);
    let csv = ["--format", "csv"];
    assert_eq!(golden(folder.path(), &[&csv[..], &["--bless"]].concat()).status.code(), Some(0));
    assert_eq!(standings(folder.path(), &csv), (Some(0), told(&[("scene.csv", "same")])));
    let (code, _) = standings(folder.path(), &[]);
    assert_eq!(code, Some(1), "two are missing, one is left over");
}

/// However many bodies, samples or listed times a scene has.
#[test]
fn goldens_of_large_scenes_are_small_too() {
    let body = |number: u32| {
        format!(
            "[[body]]\nname = \"body_{number}\"\nprincipal_moments_kg_m2 = [1.0, 2.0, 2.5]\n\
             angular_velocity_rad_s = [0.1, 2.0, {number}.0]\nvelocity_m_s = [1.0, 0.0, 0.0]\n"
        )
    };
    let many: Vec<_> = (0..30).map(body).collect();
    let folder = folder_with(&format!("duration_s = 10.0\nsample_every_s = 0.00001\n{}", many.concat()));
    let times: Vec<_> = (0..1000).map(|number| format!("{}", 0.001 * f64::from(number * number))).collect();
    let listed =
        SCENE.replace("duration_s = 1.0\nsample_every_s = 0.1", &format!("sample_times_s = [{}]", times.join(",")));
    fs::write(folder.path().join("listed.toml"), listed).expect("room");
    let output = golden(folder.path(), &["--bless"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    for (name, bodies, most_samples) in [("listed", 1, 51), ("scene", 30, 17)] {
        for format in ["mcap", "rrd"] {
            let path = folder.path().join(format!("goldens/{name}.{format}"));
            let bytes = fs::metadata(&path).expect("a golden").len();
            assert!(bytes <= MOST_BYTES, "{name}.{format}: {bytes} bytes");
            let mut recording = Recording::open(&path).expect("a recording");
            assert_eq!(recording.heading().bodies.len(), bodies);
            let names: BTreeSet<_> = recording.heading().bodies.iter().map(|body| body.channels.clone()).collect();
            assert_eq!(names.len(), 1, "every body has the same channels: {names:?}");
            let samples = recording.next_batch().expect("samples").expect("a batch").len();
            assert!((10..=most_samples).contains(&samples), "{name}.{format}: {samples} samples");
        }
    }
}
