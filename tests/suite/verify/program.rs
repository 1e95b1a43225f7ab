//! `polhode verify`: exit codes, words, JSON.

use std::path::{Path, PathBuf};
use std::process::Output;

use serde_json::Value;

use crate::cli::{SCENE, folder_with, polhode, stderr, stdout};

fn file(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn mujoco(more: &[&str]) -> Output {
    let (table, mapping) = (file("tests/foreign/mujoco.csv"), file("examples/mappings/mujoco.toml"));
    let [table, mapping] = [&table, &mapping].map(|path| path.to_str().expect("UTF-8"));
    let arguments = [&["verify", table, "--map", mapping], more].concat();
    polhode(Path::new(env!("CARGO_MANIFEST_DIR")), &arguments)
}

#[test]
fn a_recording_of_this_program_is_clean_by_the_scene_that_it_carries() {
    let folder = folder_with(&SCENE.replace("duration_s = 1.0", "duration_s = 2.0"));
    assert_eq!(polhode(folder.path(), &["run", "scene.toml"]).status.code(), Some(0));
    for name in ["recordings/scene.mcap", "recordings/scene.rrd"] {
        let output = polhode(folder.path(), &["verify", name]);
        assert_eq!(output.status.code(), Some(0), "{}{}", stdout(&output), stderr(&output));
        assert!(stdout(&output).starts_with(&format!("{name}: body: clean, within 0.001 rad")), "{}", stdout(&output));
        assert!(stdout(&output).contains("the scene in the file"), "{}", stdout(&output));
    }
}

#[test]
fn a_fault_exits_with_one_and_is_told_in_words_that_fit_a_terminal() {
    let output = mujoco(&["--principal-moments", "1,2,2.5", "--tolerance", "1e-4"]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let text = stdout(&output);
    assert!(text.lines().next().is_some_and(|line| line.contains("WRONG: explicit Euler steps of ω")), "{text}");
    for line in text.lines().skip(1) {
        assert!(line.chars().count() <= 80, "{line}");
    }
}

#[test]
fn the_inertia_may_be_a_tensor_and_the_result_json() {
    let output = mujoco(&["--inertia", "1,2,2.5,0,0,0", "--tolerance", "1e-4", "--json"]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let found: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    let body = &found["bodies"][0];
    assert_eq!(body["verdict"], "wrong");
    assert_eq!(body["causes"][0]["cause"], "explicit_step");
    assert_eq!(body["columns"]["chosen"]["axes"], "body");
    assert_eq!(body["columns"]["frame_is_decided"], true);
    assert!(body["distance"]["worst_rad"].as_f64().is_some_and(|worst| worst < 1e-3), "{body}");
}

#[test]
fn what_cannot_be_done_exits_with_two_and_says_why() {
    let cases: [(&[&str], &str); 5] = [
        (&["--principal-moments", "1,2"], "--principal-moments: 2 numbers, where it takes 3"),
        (&["--principal-moments", "1,2,9"], "triangle inequality"),
        (&["--body", "moon"], "there is no body \"moon\" in the file: there is wing nut"),
        (&["--scene", "nowhere"], "nowhere"),
        (&["--tolerance", "0"], "it must be positive and finite"),
    ];
    for (arguments, message) in cases {
        let output = mujoco(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stdout(&output));
        assert!(stderr(&output).contains(message), "{arguments:?}: {}", stderr(&output));
    }
}
