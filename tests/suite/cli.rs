//! The built program: exit codes, stdout and stderr, JSON.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

pub const SCENE: &str = "
title = \"A spin that stays\"
duration_s = 1.0
sample_every_s = 0.1

[[body]]
principal_moments_kg_m2 = [1.0, 2.0, 2.5]
angular_velocity_rad_s = [0.0, 0.0, 3.0]
";
const CHECK: &str = "
[[check.value]]
channel = \"angular_velocity\"
component = \"z\"
time_s = 1.0
expected = EXPECTED
tolerance = 1e-12
";

pub fn polhode(folder: &Path, arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_polhode");
    Command::new(program).current_dir(folder).args(arguments).output().expect("the program starts")
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("output is UTF-8")
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("output is UTF-8")
}

pub fn folder_with(scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("scene.toml"), scene).expect("the scene is written");
    folder
}

#[test]
fn run_writes_both_recordings_and_says_so() {
    let folder = folder_with(SCENE);
    let output = polhode(folder.path(), &["run", "scene.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stderr(&output), "", "no remarks where all is well and nobody watches");
    for name in ["recordings/scene.mcap", "recordings/scene.rrd"] {
        assert!(folder.path().join(name).is_file(), "{name}");
        assert!(stdout(&output).contains(name));
    }
    assert!(stdout(&output).contains("closed form: no torque acts"), "{}", stdout(&output));
}

#[test]
fn a_failed_check_exits_with_one_and_is_named() {
    let folder = folder_with(&(SCENE.to_owned() + &CHECK.replace("EXPECTED", "2.9")));
    let output = polhode(folder.path(), &["run", "scene.toml", "--format", "csv"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stdout(&output).contains("FAILED  angular_velocity z at 1 s"), "{}", stdout(&output));
    assert!(stderr(&output).contains("check failed: angular_velocity z at 1 s"), "{}", stderr(&output));
    assert!(folder.path().join("recordings/scene.csv").is_file(), "the recording is kept: it shows what went wrong");
}

#[test]
fn an_existing_recording_is_overwritten_only_by_force() {
    let folder = folder_with(SCENE);
    let run = ["run", "scene.toml", "--format", "csv"];
    assert_eq!(polhode(folder.path(), &run).status.code(), Some(0));
    let path = folder.path().join("recordings/scene.csv");
    fs::write(&path, "precious").expect("the recording is replaced");
    let refused = polhode(folder.path(), &run);
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("--force overwrites it"), "{}", stderr(&refused));
    assert_eq!(fs::read_to_string(&path).expect("it is there"), "precious");
    let forced = polhode(folder.path(), &["run", "scene.toml", "--format", "csv", "--force"]);
    assert_eq!(forced.status.code(), Some(0));
    assert!(fs::read_to_string(&path).expect("it is there").starts_with("time_s,"));
}

#[test]
fn flags_change_keys_under_the_same_rules() {
    let folder = folder_with(SCENE);
    let flags = ["run", "scene.toml", "--format", "csv", "--json", "--duration", "2", "--sample-every", "0.5"];
    let method = ["--method", "taylor", "--set", "body.0.angular_velocity_rad_s=[0, 0, 1]"];
    let output = polhode(folder.path(), &[&flags[..], &method[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let report: Value = serde_json::from_slice(&output.stdout).expect("stdout is JSON");
    assert_eq!(report[0]["samples"], 5);
    assert_eq!(report[0]["bodies"][0]["path"], "Taylor");
    let refused = polhode(folder.path(), &["run", "scene.toml", "--duration", "-2"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("duration_s: -2.0 must be positive"), "{}", stderr(&refused));
}

#[test]
fn a_channel_list_is_all_that_is_recorded() {
    let folder = folder_with(SCENE);
    let arguments = ["run", "scene.toml", "--format", "csv", "--channels", "angular_velocity,rotational_energy"];
    assert_eq!(polhode(folder.path(), &arguments).status.code(), Some(0));
    let table = fs::read_to_string(folder.path().join("recordings/scene.csv")).expect("it is there");
    let header =
        "time_s,angular_velocity_x_rad_s,angular_velocity_y_rad_s,angular_velocity_z_rad_s,rotational_energy_j";
    assert_eq!(table.lines().next(), Some(header));
}

#[test]
fn a_layout_beside_an_mcap_names_what_is_recorded() {
    let folder = folder_with(SCENE);
    let arguments = ["run", "scene.toml", "--format", "mcap", "--channels", "attitude,angular_velocity,slip"];
    assert_eq!(polhode(folder.path(), &arguments).status.code(), Some(0));
    let path = folder.path().join("recordings/scene.layout.json");
    let layout: Value = serde_json::from_slice(&fs::read(&path).expect("it is there")).expect("it is JSON");
    let panels = layout["configById"].as_object().expect("panels");
    let paths = panels.values().filter_map(|panel| panel["paths"].as_array()).flatten();
    let fields: Vec<_> =
        paths.filter_map(|path| path["value"].as_str()?.split_once("/state.")).map(|(_, f)| f).collect();
    assert_eq!(fields, ["angular_velocity.x", "angular_velocity.y", "angular_velocity.z", "slip"]);
    let refused = polhode(folder.path(), &arguments);
    assert_eq!(refused.status.code(), Some(2), "neither file is overwritten");
}

#[test]
fn bad_scenes_and_usage_exit_with_two() {
    let folder = folder_with("duration_s = -1.0\nsample_every_s = 0.1\n");
    let refused = polhode(folder.path(), &["run", "scene.toml"]);
    assert_eq!(refused.status.code(), Some(2));
    assert_eq!(stdout(&refused), "");
    assert!(stderr(&refused).contains("scene.toml:1:14: duration_s: -1.0"), "{}", stderr(&refused));
    assert!(!folder.path().join("recordings").exists(), "a refused scene leaves nothing behind");
    for arguments in [&["run"][..], &["run", "dzhanibekof"], &["run", "a.toml", "--format", "bag"], &["fly"]] {
        assert_eq!(polhode(folder.path(), arguments).status.code(), Some(2), "{arguments:?}");
    }
    assert!(stderr(&polhode(folder.path(), &["run", "dzhanibekof"])).contains("did you mean \"dzhanibekov\"?"));
}

#[test]
fn a_viewer_that_is_not_there_is_said_before_the_run_and_nothing_is_written() {
    let folder = folder_with(SCENE);
    // Nothing listens on the port of tcpmux.
    let output = polhode(folder.path(), &["run", "scene.toml", "--live=rerun+http://127.0.0.1:1/proxy"]);
    assert_eq!(output.status.code(), Some(2));
    let expected = if cfg!(feature = "live") { "cannot show the run in the viewer at" } else { "cargo feature `live`" };
    assert!(stderr(&output).contains(expected), "{}", stderr(&output));
    assert!(!folder.path().join("recordings/scene.mcap").exists());
}

#[test]
fn plan_names_path_reason_and_what_is_skipped() {
    let folder = folder_with(SCENE);
    let output = polhode(folder.path(), &["plan", "scene.toml", "--channels", "angular_velocity"]);
    assert_eq!(output.status.code(), Some(0));
    for words in ["closed form: no torque acts", "attitude: no channel needs it", "translation: nothing moves"] {
        assert!(stdout(&output).contains(words), "{words}: {}", stdout(&output));
    }
}

#[test]
fn inspect_shows_what_run_wrote() {
    let folder = folder_with(SCENE);
    assert_eq!(polhode(folder.path(), &["run", "scene.toml", "--format", "mcap,rrd,csv"]).status.code(), Some(0));
    for name in ["recordings/scene.mcap", "recordings/scene.rrd", "recordings/scene.csv"] {
        let output = polhode(folder.path(), &["inspect", name, "--json"]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", stderr(&output));
        let contents: Value = serde_json::from_slice(&output.stdout).expect("stdout is JSON");
        let entries = contents["entries"].as_array().expect("a list of entries");
        assert!(entries.iter().any(|entry| entry["count"] == 11), "{name} has 11 samples: {contents:#}");
        let recording = &contents["recording"];
        assert_eq!(recording["samples"], 11, "{name}");
        let columns = recording["bodies"][0]["columns"].as_array().expect("a list of columns");
        let is_told =
            |column: &Value| column["least"].as_f64() <= column["greatest"].as_f64() && column["unit"].is_string();
        assert!(!columns.is_empty() && columns.iter().all(is_told), "{name}: {contents:#}");
    }
    assert_eq!(polhode(folder.path(), &["inspect", "scene.toml"]).status.code(), Some(2));
}

#[test]
fn recordings_say_what_the_checks_have_found() {
    let folder = folder_with(&format!("{SCENE}{}", CHECK.replace("EXPECTED", "3.0")));
    assert_eq!(polhode(folder.path(), &["run", "scene.toml"]).status.code(), Some(0));
    for name in ["recordings/scene.mcap", "recordings/scene.rrd"] {
        let told = stdout(&polhode(folder.path(), &["inspect", name]));
        let finding = "angular_velocity z at 1 s: 3.0 rad/s, expected 3.0 ± 1e-12: passed";
        assert!(told.contains("check.001") && told.contains(finding), "{name}: {told}");
    }
}

#[test]
fn list_names_every_scene() {
    let output = polhode(Path::new("."), &["list", "--json"]);
    let scenes: Value = serde_json::from_slice(&output.stdout).expect("stdout is JSON");
    assert!(scenes.as_array().is_some_and(|scenes| scenes.len() >= 15));
}

#[test]
fn bench_measures_draws_and_tabulates() {
    let folder = folder_with(SCENE);
    let files = ["--csv", "costs.csv", "--plot", "costs.svg", "--plot", "costs.png"];
    let asked = ["bench", "scene.toml", "--json", "--errors", "1e-3,1e-6", "--budget", "0"];
    let output = polhode(folder.path(), &[&asked[..], &files[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let studies: Value = serde_json::from_slice(&output.stdout).expect("stdout is JSON");
    let study = &studies[0]["bodies"][0];
    assert_eq!(study["picked_by_auto"], "closed_form");
    assert!(study["levels"].as_array().is_some_and(|levels| levels.iter().all(|level| !level["point"].is_null())));
    let read = |name: &str| fs::read(folder.path().join(name)).expect("the file is written");
    assert!(read("costs.svg").starts_with(b"<svg"));
    assert!(read("costs.png").starts_with(b"\x89PNG"));
    let table = String::from_utf8(read("costs.csv")).expect("UTF-8");
    assert_eq!(table.lines().count(), 1 + study["points"].as_array().expect("points").len());
}

#[test]
fn bench_refuses_what_it_cannot_do() {
    let folder = folder_with(SCENE);
    for (flags, words) in [
        (["--methods", "euler"], "is no method"),
        (["--errors", "0"], "must be positive"),
        (["--plot", "costs.pdf"], "ends in .svg or .png"),
        (["--csv", "costs.txt"], "ends in .csv"),
    ] {
        let output = polhode(folder.path(), &[&["bench", "scene.toml", "--budget", "0"], &flags[..]].concat());
        assert!(output.stdout.is_empty(), "{flags:?} is refused before anything is measured");
        assert_eq!(output.status.code(), Some(2), "{flags:?}");
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
    }
}

#[test]
fn a_certified_run_says_its_error_records_it_and_is_held_to_its_tolerance() {
    let folder = folder_with(SCENE);
    let run = ["run", "scene.toml", "--certify", "--force"];
    let output = polhode(folder.path(), &run);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).contains("certified") && stdout(&output).contains("attitude "), "{}", stdout(&output));
    let recordings = ["scene.mcap", "scene.rrd"].map(|name| folder.path().join("recordings").join(name));
    let bytes = recordings.each_ref().map(|path| fs::read(path).expect("it is there"));
    let again = polhode(folder.path(), &[&run[..], &["--json"]].concat());
    let report: Value = serde_json::from_slice(&again.stdout).expect("stdout is JSON");
    let certificate = &report[0]["bodies"][0]["certificate"];
    assert!(certificate["attitude_rad"].as_f64().is_some_and(|error| error < 1e-14), "{certificate:#}");
    for (path, bytes) in recordings.iter().zip(&bytes) {
        assert_eq!(fs::read(path).expect("it is there"), *bytes, "{}", path.display());
    }
    let name = b"body.body.certificate.attitude_error_rad";
    assert!(bytes[0].windows(name.len()).any(|window| window == name), "the .mcap carries the certificate");

    let long = ["run", "scene.toml", "--certify", "--format", "csv", "--duration", "1000", "--sample-every", "10"];
    let missed = polhode(folder.path(), &[&long[..], &["--method", "dop853", "--tolerance", "2e-15"]].concat());
    assert_eq!(missed.status.code(), Some(1), "{}", stdout(&missed));
    assert!(stderr(&missed).contains("tolerance missed: body is"), "{}", stderr(&missed));
}
