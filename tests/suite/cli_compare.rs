//! `polhode compare` and `polhode digest`: exit codes, table, JSON.

use std::fs;

use serde_json::Value;

use crate::cli::{SCENE, folder_with, polhode, stderr, stdout};

fn json(output: &std::process::Output) -> Value {
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// A folder with `scene.toml` and its recordings in each format.
fn recorded() -> tempfile::TempDir {
    let folder = folder_with(SCENE);
    let output = polhode(folder.path(), &["run", "scene.toml", "--format", "mcap,rrd,csv", "--out", "."]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    folder
}

#[test]
fn the_same_run_is_the_same_and_has_one_digest() {
    let folder = recorded();
    let files = ["scene.mcap", "scene.rrd", "scene.csv"];
    for other in ["scene.rrd", "scene.csv", "scene.toml"] {
        let output = polhode(folder.path(), &["compare", "scene.mcap", other, "--exact"]);
        assert_eq!((output.status.code(), stderr(&output)), (Some(0), String::new()));
        let text = stdout(&output);
        assert!(text.starts_with("Same means: every bit counts\n"), "{text}");
        assert!(text.ends_with("\nsame to the bit, at 11 times\n"), "{text}");
    }
    let output = polhode(folder.path(), &[&["digest"], &files[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let text = stdout(&output);
    let lines: Vec<_> = text.lines().map(|line| line.split_once("  ").expect("as sha256sum has it")).collect();
    assert_eq!(lines.iter().map(|(_, file)| *file).collect::<Vec<_>>(), files);
    assert!(lines.iter().all(|(hash, _)| *hash == lines[0].0 && hash.len() == 64), "{text}");
    // One number by one ulp.
    let table = fs::read_to_string(folder.path().join("scene.csv")).expect("there");
    let changed = table.replacen(",3.0,", ",3.0000000000000004,", 1);
    assert_ne!(changed, table);
    fs::write(folder.path().join("changed.csv"), changed).expect("room");
    let output = polhode(folder.path(), &["digest", "changed.csv", "scene.csv", "none.csv", "--json"]);
    assert_eq!(output.status.code(), Some(2));
    let found = json(&output);
    assert_ne!(found[0]["sha256"], found[1]["sha256"]);
    assert_eq!(found[1]["sha256"], lines[0].0);
    assert_eq!(found[1]["samples"].as_u64(), Some(11));
    assert!(found[2]["error"].as_str().expect("words").contains("none.csv"));
}

#[test]
fn another_motion_exits_with_one_and_says_where_and_since_when() {
    let folder = recorded();
    let other = ["compare", "scene.mcap", "scene.toml", "--set-b", "body.0.angular_velocity_rad_s=[0, 0, 3.00001]"];
    let output = polhode(folder.path(), &other);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let text = stdout(&output);
    assert!(text.contains("\n✗  attitude"), "{text}");
    assert!(text.contains("\n     out from 0.1 s on"), "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    assert!(text.trim_end().lines().rev().take(2).any(|line| line.starts_with("differs: ")), "{text}");

    let found = json(&polhode(folder.path(), &[&other[..], &["--json"]].concat()));
    assert_eq!(found["finding"], "different");
    assert_eq!(found["same"], false);
    assert_eq!(found["b"]["is_scene"], true);
    let channels = found["bodies"][0]["channels"].as_array().expect("channels");
    let attitude = channels.iter().find(|channel| channel["channel"] == "attitude").expect("compared");
    // 1e-5 rad/s for a second.
    let worst = attitude["worst"].as_f64().expect("a number");
    assert!((worst - 1e-5).abs() < 1e-12, "{worst}");
    assert_eq!(attitude["worst_at_s"].as_f64(), Some(1.0));
    assert_eq!(attitude["first_out_s"].as_f64(), Some(0.1));
    assert_eq!(attitude["unit"], "rad");
    assert!(found["facts"].as_array().expect("facts").iter().any(|fact| fact["name"] == "scene_sha256"));
    for key in ["same_to_the_bit", "verdict", "exact", "a", "b", "shift_s", "common", "times_apart_s", "differences"] {
        assert!(!found[key].is_null(), "{key}");
    }
    for key in [
        "title",
        "finding",
        "rule",
        "absolute",
        "relative",
        "limit",
        "samples",
        "size",
        "worst_relative",
        "rms",
        "differing_samples",
        "most_ulps",
        "first_differing",
    ] {
        assert!(!attitude[key].is_null(), "{key}");
    }
    for key in ["interpolation", "worst_component", "growth"] {
        assert!(attitude.get(key).is_some(), "{key}");
    }
    // Within what was asked for it is the same.
    fs::write(folder.path().join("limits.toml"), "attitude_rad = 1e-4\n").expect("room");
    let wide = ["--tolerances", "limits.toml", "--channels", "attitude"];
    assert_eq!(polhode(folder.path(), &[&other[..], &wide].concat()).status.code(), Some(0));
    let narrow = [&other[..], &wide, &["--tolerance", "attitude=1e-6"]].concat();
    assert_eq!(polhode(folder.path(), &narrow).status.code(), Some(1), "a flag comes after the file");
}

#[test]
fn both_motions_are_drawn_over_each_other_with_the_same_bytes_each_time() {
    let folder = recorded();
    let other = ["compare", "scene.csv", "scene.toml", "--set-b", "body.0.angular_velocity_rad_s=[0, 0, 3.00001]"];
    let drawn = |rrd: &str, svg: &str| {
        let output = polhode(folder.path(), &[&other[..], &["--record", rrd, "--plot", svg]].concat());
        assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
        [rrd, svg].map(|file| fs::read(folder.path().join(file)).expect("it is there"))
    };
    let one = drawn("one.rrd", "one.svg");
    assert!(one == drawn("two.rrd", "two.svg"), "other bytes");
    let found = json(&polhode(folder.path(), &["inspect", "one.rrd", "--json"]));
    assert_eq!(found["is_whole"], true);
    let entries = found["entries"].as_array().expect("entries");
    let count = |name: &str| {
        let of_name = entries.iter().filter(|entry| entry["name"] == name);
        of_name.filter_map(|entry| entry["count"].as_u64()).max().unwrap_or(0)
    };
    // Both bodies at every time, and the differences that are not 0, as they are at the start.
    assert_eq!((count("/world/a/body"), count("/world/b/body")), (11, 11), "{found}");
    assert_eq!(count("/difference/body/attitude"), 10, "{found}");
    for (arguments, message) in [
        (&["--record", "one.rrd"][..], "error: one.rrd exists already: --force overwrites it"),
        (&["--record", "three.mcap"], "error: three.mcap: two motions over each other are an .rrd"),
        (&["--plot", "one.pdf"], "error: cannot draw one.pdf: a plot's name ends in .svg or .png"),
    ] {
        let output = polhode(folder.path(), &[&other[..], arguments].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr(&output).starts_with(message), "{}", stderr(&output));
    }
    assert!(!folder.path().join("three.mcap.part").exists(), "a name that is refused leaves nothing");
}

#[test]
fn what_cannot_be_compared_exits_with_two() {
    let folder = recorded();
    for (arguments, message) in [
        (&["scene.mcap", "none.mcap"][..], "error: cannot read none.mcap: "),
        (&["scene.mcap", "dzanibekov"], "error: no scene is called \"dzanibekov\"; did you mean \"dzhanibekov\"?"),
        (&["scene.mcap", "scene.rrd", "--tolerance", "tlt=1"], "error: \"tlt\" is no channel; did you mean \"tilt\"?"),
        (&["scene.mcap", "scene.rrd", "--channels", "tlt"], "error: \"tlt\" is no channel; did you mean \"tilt\"?"),
        (
            &["scene.mcap", "scene.rrd", "--set-b", "step_s=1"],
            "error: --set-b is for a scene, and scene.rrd is a recording",
        ),
        (&["scene.mcap", "scene.rrd", "--body", "one"], "error: --body \"one\": it reads A=B"),
        (&["scene.mcap", "scene.rrd", "--shift", "NaN"], "error: --shift NaN: a finite number of seconds"),
        (&["scene.mcap", "scene.rrd", "--shift", "0.05"], "error: the sides have 0 of their times in common"),
        (&["scene.mcap", "scene.rrd", "--from", "7"], "error: scene.mcap has no sample from 7 s on"),
        (&["scene.mcap", "scene.rrd", "--exact", "--resample"], "error: the argument '--exact' cannot be used with"),
    ] {
        let output = polhode(folder.path(), &[&["compare"], arguments].concat());
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), String::new()), "{arguments:?}");
        assert!(stderr(&output).starts_with(message), "{}", stderr(&output));
    }
}
