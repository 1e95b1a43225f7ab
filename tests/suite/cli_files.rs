//! The built program on recordings: convert, recover, view, inspect.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

use crate::cli::{SCENE, folder_with, polhode, stderr, stdout};

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).expect("stdout is JSON")
}

fn run_all_formats(folder: &Path) {
    let output = polhode(folder, &["run", "scene.toml", "--format", "mcap,rrd,csv", "--out", "."]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
}

fn same(folder: &Path, [a, b]: [&str; 2]) -> bool {
    fs::read(folder.join(a)).expect("a file") == fs::read(folder.join(b)).expect("a file")
}

#[test]
fn convert_gives_what_a_run_gives_and_a_layout_beside_it() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    run_all_formats(folder);
    let output = polhode(folder, &["convert", "scene.mcap", "a.rrd", "a.csv", "--json"]);
    assert_eq!((output.status.code(), stderr(&output).as_str()), (Some(0), ""));
    let report = json(&output);
    assert_eq!((&report["samples"], &report["has_scene"]), (&Value::from(11), &Value::from(true)));
    let output = polhode(folder, &["convert", "a.rrd", "b.mcap"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).starts_with("a.rrd: 11 samples, to 1 s\n  b.mcap  "), "{}", stdout(&output));
    let pairs = [
        ["scene.rrd", "a.rrd"],
        ["scene.csv", "a.csv"],
        ["scene.mcap", "b.mcap"],
        ["scene.layout.json", "b.layout.json"],
    ];
    for pair in pairs {
        assert!(same(folder, pair), "{pair:?}");
    }
    let taken = polhode(folder, &["convert", "a.rrd", "b.mcap"]);
    assert_eq!(taken.status.code(), Some(2));
    assert!(stderr(&taken).contains("--force overwrites it"), "{}", stderr(&taken));
    assert_eq!(polhode(folder, &["convert", "a.rrd", "b.mcap", "--force"]).status.code(), Some(0));
}

#[test]
fn a_table_gets_pictures_from_its_scene_only() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    run_all_formats(folder);
    let plain = polhode(folder, &["convert", "scene.csv", "plain.mcap"]);
    assert_eq!(plain.status.code(), Some(0));
    assert!(stderr(&plain).contains("nothing is drawn: it carries no scene"), "{}", stderr(&plain));
    assert!(!folder.join("plain.layout.json").exists());
    let drawn = polhode(folder, &["convert", "scene.csv", "drawn.mcap", "--scene", "scene.toml"]);
    assert_eq!((drawn.status.code(), stderr(&drawn).as_str()), (Some(0), ""));
    assert!(folder.join("drawn.layout.json").is_file());
    let later = polhode(folder, &["convert", "plain.mcap", "later.rrd", "--scene", "scene.toml"]);
    assert_eq!((later.status.code(), stderr(&later).as_str()), (Some(0), ""), "what was made of a table, too");
    let other = ["convert", "scene.csv", "other.mcap", "--scene", "scene.toml", "--set"];
    let refused = polhode(folder, &[&other[..], &["body.0.angular_velocity_rad_s=[0, 0, 2]"]].concat());
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        stderr(&refused).contains("is no recording of that scene: attitude of body at 1 s"),
        "{}",
        stderr(&refused)
    );
    assert!(!folder.join("other.mcap").exists());
    assert_eq!(polhode(folder, &["convert", "scene.toml", "x.rrd"]).status.code(), Some(2));
    assert_eq!(polhode(folder, &["convert", "scene.mcap", "x.bag"]).status.code(), Some(2));
    assert_eq!(polhode(folder, &["convert", "scene.mcap"]).status.code(), Some(2));
}

#[test]
fn meshes_are_looked_for_beside_the_recording_and_by_the_scene() {
    let folder = folder_with(
        "duration_s = 1.0\nsample_every_s = 0.1\n[[body]]\nangular_velocity_rad_s = [0.1, 2.0, 0.0]\n\
         [body.mesh]\nfile = \"shape.obj\"\ndensity_kg_m3 = 1000.0\n",
    );
    let folder = folder.path();
    let shape = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    fs::write(folder.join("shape.obj"), shape).expect("room");
    let run = polhode(folder, &["run", "scene.toml", "--format", "mcap,rrd"]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let plain = polhode(folder, &["convert", "recordings/scene.mcap", "plain.rrd"]);
    assert_eq!(plain.status.code(), Some(0), "{}", stderr(&plain));
    assert!(stderr(&plain).contains("its scene cannot be planned"), "{}", stderr(&plain));
    let drawn = polhode(folder, &["convert", "recordings/scene.mcap", "drawn.rrd", "--scene", "scene.toml"]);
    assert_eq!((drawn.status.code(), stderr(&drawn).as_str()), (Some(0), ""));
    assert!(same(folder, ["drawn.rrd", "recordings/scene.rrd"]));
    fs::write(folder.join("recordings/shape.obj"), shape.replace("0 0 3", "0 0 4")).expect("room");
    let other = polhode(folder, &["convert", "recordings/scene.mcap", "other.rrd"]);
    assert!(stderr(&other).contains("identity_sha256 is"), "another mesh of the same name: {}", stderr(&other));
    fs::write(folder.join("recordings/shape.obj"), shape).expect("room");
    let beside = polhode(folder, &["convert", "recordings/scene.mcap", "beside.rrd"]);
    assert_eq!((beside.status.code(), stderr(&beside).as_str()), (Some(0), ""));
    assert!(same(folder, ["beside.rrd", "recordings/scene.rrd"]));
}

#[test]
fn recover_says_how_much_it_kept_and_refuses_what_it_must() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    run_all_formats(folder);
    for name in ["scene.mcap", "scene.rrd", "scene.csv"] {
        let whole = fs::read(folder.join(name)).expect("a recording");
        let part = format!("{name}.part");
        fs::write(folder.join(&part), &whole[..whole.len() - 20]).expect("room");
        let refused = polhode(folder, &["recover", &part]);
        assert_eq!(refused.status.code(), Some(2), "it is there");
        let output = polhode(folder, &["recover", &part, "--output", &format!("new_{name}")]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let kept = if name.ends_with("csv") { "10 samples kept, to 0.9" } else { "11 of 11 samples kept, to 1 s" };
        assert!(stdout(&output).contains(kept), "{}", stdout(&output));
        assert!(!folder.join(&part).exists());
        fs::write(folder.join(&part), &whole[..20]).expect("room");
        let nothing = polhode(folder, &["recover", &part, "--force", "--json"]);
        assert_eq!(nothing.status.code(), Some(2), "{name}");
        assert!(folder.join(&part).exists(), "what cannot be recovered is not removed");
    }
    assert!(same(folder, ["new_scene.mcap", "scene.mcap"]), "only its index was missing");
    assert!(same(folder, ["new_scene.rrd", "scene.rrd"]), "only its footer was missing");
    assert_eq!(polhode(folder, &["recover", "scene.mcap"]).status.code(), Some(2), "no part");
}

#[test]
fn inspect_tells_the_same_of_every_format() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    let output = polhode(folder, &["run", "scene.toml", "--format", "mcap,rrd,csv", "--out", ".", "--certify"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let told = ["mcap", "rrd", "csv"].map(|format| {
        let output = polhode(folder, &["inspect", &format!("scene.{format}"), "--json"]);
        let contents = json(&output);
        let keys: Vec<_> = contents.as_object().expect("an object").keys().cloned().collect();
        assert_eq!(keys, ["details", "entries", "file", "format", "is_whole", "recording"]);
        assert_eq!((&contents["format"], &contents["is_whole"]), (&Value::from(format), &Value::from(true)));
        contents["recording"].clone()
    });
    let keys: Vec<_> = told[0].as_object().expect("an object").keys().cloned().collect();
    assert_eq!(keys, ["bodies", "from_s", "interval_s", "provenance", "samples", "scene", "to_s"]);
    assert_eq!(told[0], told[1], ".mcap and .rrd say the same");
    assert_eq!(told[0]["scene"], SCENE);
    assert!(told[0]["provenance"]["body.body.method"].is_string());
    assert!(told[0]["bodies"][0]["certificate"]["attitude_error_rad"].is_string());
    assert_eq!(told[0]["interval_s"], 0.1);
    assert_eq!(told[0]["bodies"][0]["columns"], told[2]["bodies"][0]["columns"]);
    assert_eq!((&told[2]["samples"], &told[2]["scene"]), (&Value::from(11), &Value::Null));
}

/// Runs the program where the first `rerun` on PATH is a script of ours.
#[cfg(unix)]
fn view(folder: &Path, script: Option<&str>, what: &str) -> Output {
    use std::os::unix::fs::PermissionsExt;
    let bin = folder.join("bin");
    fs::create_dir_all(&bin).expect("room");
    let viewer = bin.join("rerun");
    if let Some(script) = script {
        fs::write(&viewer, format!("#!/bin/sh\n{script}\n")).expect("room");
        fs::set_permissions(&viewer, fs::Permissions::from_mode(0o755)).expect("ours");
    }
    let temporary = folder.join("tmp");
    fs::create_dir_all(&temporary).expect("room");
    let mut program = Command::new(env!("CARGO_BIN_EXE_polhode"));
    program.current_dir(folder).env("PATH", &bin).env("TMPDIR", &temporary).args(["view", what]);
    program.output().expect("the program starts")
}

#[cfg(unix)]
#[test]
fn view_opens_the_viewer_on_path_with_an_rrd() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    run_all_formats(folder);
    // Says what it was asked to open; `read` and `echo` are the shell's own, as nothing else is on this PATH.
    let script = "echo \"$#\" \"$1\"; IFS= read -r start < \"$1\"; case \"$start\" in RRF2*) echo an rrd;; esac";
    for (what, opened) in [
        ("scene.rrd", "1 scene.rrd"),
        ("scene.mcap", "/scene.rrd"),
        ("scene.csv", "/scene.rrd"),
        ("scene.toml", "/scene.rrd"),
        ("spin_up", "/spin_up.rrd"),
    ] {
        let output = view(folder, Some(script), what);
        assert_eq!(output.status.code(), Some(0), "{what}: {}", stderr(&output));
        let said = stdout(&output);
        assert!(said.contains(opened) && said.contains("an rrd"), "{what}: {said}");
        assert_eq!(fs::read_dir(folder.join("tmp")).expect("a folder").count(), 0, "{what}: nothing is left");
    }
    let failed = view(folder, Some("exit 3"), "scene.mcap");
    assert_eq!(failed.status.code(), Some(2));
    assert!(stderr(&failed).contains("exit status: 3"), "{}", stderr(&failed));
    for absent in ["absent.rrd", "absent.mcap", "absent_scene", "scene.rrd.part"] {
        assert_eq!(view(folder, Some(script), absent).status.code(), Some(2), "{absent}");
    }
}

#[cfg(unix)]
#[test]
fn view_says_how_to_get_a_viewer() {
    let folder = folder_with(SCENE);
    let output = view(folder.path(), None, "scene.toml");
    assert_eq!((output.status.code(), stdout(&output).as_str()), (Some(2), ""));
    for words in ["no Rerun viewer", "pip install rerun-sdk==0.36.3", "cargo install rerun-cli@0.36.3"] {
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
    }
}
