//! The built program on scenes that are being written: schema, new, check.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::cli::{SCENE, folder_with, polhode, stderr, stdout};

#[test]
fn schema_prints_the_committed_schema() {
    let output = polhode(Path::new("."), &["schema"]);
    assert_eq!(output.status.code(), Some(0));
    let committed = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/scene.schema.json"));
    assert!(stdout(&output) == committed.expect("it is there"));
}

#[test]
fn new_scenes_are_sound_run_and_pass_their_checks() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    for template in ["free", "pivot", "torque"] {
        let output = polhode(folder, &["new", template, "--template", template]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let file = format!("{template}.toml");
        let text = fs::read_to_string(folder.join(&file)).expect("it is written");
        assert!(text.starts_with("# Say here what to see: "), "{text}");
        let checked = polhode(folder, &["check", &file]);
        assert!(checked.status.code() == Some(0) && stdout(&checked).contains(": sound"), "{}", stderr(&checked));
        let ran = polhode(folder, &["run", &file, "--format", "csv"]);
        assert_eq!(ran.status.code(), Some(0), "{}{}", stdout(&ran), stderr(&ran));
    }
}

#[test]
fn new_copies_scenes_and_keeps_what_is_there() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    let copied = polhode(folder, &["new", "mine.toml", "--from", "lagrange_top"]);
    assert_eq!(copied.status.code(), Some(0), "{}", stderr(&copied));
    let text = fs::read_to_string(folder.join("mine.toml")).expect("it is written");
    let printed = polhode(folder, &["new", "-", "--from", "lagrange_top"]);
    assert!(stdout(&printed) == text && stderr(&printed).is_empty() && text.contains("[[check."));
    let refused = polhode(folder, &["new", "scene"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("scene.toml exists already: --force overwrites it"), "{}", stderr(&refused));
    assert_eq!(fs::read_to_string(folder.join("scene.toml")).expect("it is there"), SCENE);
    assert_eq!(polhode(folder, &["new", "scene", "--force"]).status.code(), Some(0));
    assert_ne!(fs::read_to_string(folder.join("scene.toml")).expect("it is there"), SCENE);
    for (arguments, words) in [
        (&["new", "x", "--from", "lagrange_topp"][..], "did you mean \"lagrange_top\"?"),
        (&["new", "x.json"], "ends in .toml"),
    ] {
        let output = polhode(folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
    }
    assert!(!folder.join("x.toml").exists());
}

#[test]
fn check_tells_path_and_cost_and_writes_nothing() {
    let folder = folder_with(SCENE);
    let output = polhode(folder.path(), &["check", "scene.toml", "gravity_gradient"]);
    assert_eq!((output.status.code(), stderr(&output).as_str()), (Some(0), ""));
    for words in ["scene.toml: sound", "closed form: no torque acts", "11 evaluations, no steps", "Taylor: ", " steps"]
    {
        assert!(stdout(&output).contains(words), "{words}: {}", stdout(&output));
    }
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1, "only the scene");
    let stepped = ["check", "scene.toml", "--json", "--set", "method=rk4", "--set", "step_s=0.03"];
    let output = polhode(folder.path(), &stepped);
    let found: Value = serde_json::from_slice(&output.stdout).expect("stdout is JSON");
    // Ten intervals of 0.1 s, each in four steps of at most 0.03 s: as many as a run takes.
    assert_eq!((&found[0]["bodies"][0]["steps"], &found[0]["is_sound"]), (&Value::from(40), &Value::from(true)));
    let ran = polhode(folder.path(), &[&["run", "--format", "csv"], &stepped[1..]].concat());
    let ran: Value = serde_json::from_slice(&ran.stdout).expect("stdout is JSON");
    assert_eq!(ran[0]["steps"], 40);
}

#[test]
fn check_tells_every_fault_of_every_file() {
    let folder = folder_with(SCENE);
    let bad = SCENE.replace("title", "titel").replace("sample_every_s = 0.1", "sample_every_s = true");
    fs::write(folder.path().join("bad.toml"), bad).expect("room");
    fs::write(folder.path().join("worse.toml"), SCENE.replace("2.5", "25")).expect("room");
    let files = ["check", "bad.toml", "scene.toml", "worse.toml", "absent.toml"];
    let output = polhode(folder.path(), &files);
    assert_eq!(output.status.code(), Some(2));
    assert!(stdout(&output).starts_with("scene.toml: sound"), "{}", stdout(&output));
    for words in [
        "error: bad.toml:2:1: titel: no such key; did you mean `title`?",
        "error: bad.toml:4:18: sample_every_s: invalid type",
        "error: worse.toml:7:27: body[0].principal_moments_kg_m2: ",
        "error: cannot read the scene absent.toml: ",
    ] {
        assert!(stderr(&output).contains(words), "{words}: {}", stderr(&output));
    }
    let output = polhode(folder.path(), &[&files[..], &["--json"]].concat());
    assert_eq!(output.status.code(), Some(2));
    let found: Value = serde_json::from_slice(&output.stdout).expect("stdout is JSON");
    assert_eq!(found.as_array().map(Vec::len), Some(4));
    let faults = found[0]["faults"].as_array().expect("a list of faults");
    assert_eq!(faults.len(), 2);
    let fault = faults.iter().find(|fault| fault["key"] == "titel").expect("the misspelt key");
    assert_eq!((&fault["line"], &fault["column"]), (&Value::from(2), &Value::from(1)));
}
