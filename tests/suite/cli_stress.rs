//! `polhode stress` as the built program does it.

use std::fs;

use serde_json::Value;

use crate::cli::{polhode, stderr, stdout};

#[test]
fn stress_prints_a_matrix_of_eighty_columns_that_reads_without_colour() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = polhode(folder.path(), &["stress", "--cases", "rest,torque_1e300,mujoco_3553_turned"]);
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(!text.contains('\x1b'), "colour where nobody watches: {text}");
    assert!(text.lines().filter(|line| !line.contains(", auto: ")).all(|line| line.chars().count() <= 80), "{text}");
    let heads: Vec<&str> = text.lines().filter(|line| line.ends_with("k4") && line.contains(" au cf ")).collect();
    let groups: Vec<&str> = heads.iter().filter_map(|line| line.split("  ").next()).collect();
    assert_eq!(groups, ["SHAPES", "FRAMES", "EXTREME LOADS"], "{text}");
    assert!(text.contains(" 0 wrong"), "{text}");
    assert!(text.contains("torque_1e300, auto: ") && text.contains("at most 1e11"), "{text}");
}

#[test]
fn stress_tells_every_run_and_draws() {
    let folder = tempfile::tempdir().expect("a folder");
    let asked = ["stress", "--cases", "principal_axis", "--methods", "auto,rk4", "--json", "--plot", "heat.svg"];
    let output = polhode(folder.path(), &[&asked[..], &["--plot", "heat.png"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let rows: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    let cells = rows[0]["cells"].as_array().expect("cells");
    assert_eq!(cells.len(), 2);
    assert_eq!((&cells[0]["verdict"], &cells[1]["verdict"]), (&"kept".into(), &"coarse".into()));
    let runs = cells[1]["runs"].as_array().expect("runs");
    assert_eq!(runs.len(), 2);
    let steps = runs.iter().map(|run| run["steps"].as_u64().expect("a count"));
    assert!(steps.is_sorted(), "from coarse to fine: {runs:#?}");
    let svg = fs::read_to_string(folder.path().join("heat.svg")).expect("drawn");
    assert!(svg.contains("steady spin about the largest moment") && svg.contains("rk4"), "{svg}");
    assert_eq!(fs::read(folder.path().join("heat.png")).expect("drawn")[1..4], *b"PNG");
}

/// Each of the matrices on its own, and what they are made of as JSON.
#[test]
fn stress_tells_growth_and_where_methods_break() {
    let folder = tempfile::tempdir().expect("a folder");
    let asked = ["stress", "--cases", "tumbling", "--methods", "closed_form,rk4,euler_naive"];
    let row = |what: &str| {
        let output = polhode(folder.path(), &[&asked[..], &["--show", what]].concat());
        let text = stdout(&output);
        let row = text.lines().find(|line| line.starts_with("tumbling")).expect("a row").to_owned();
        row.split_whitespace().skip(1).map(str::to_owned).collect::<Vec<_>>()
    };
    // RK4 keeps the motion to a microradian at 128 steps a turn; Euler's explicit method is lost with as many.
    let energy = row("energy");
    assert!(energy.iter().all(|sign| sign.starts_with(|letter: char| letter.is_ascii_digit())), "{energy:?}");
    let breaks = row("breaks");
    assert_eq!(breaks[0], "·", "a closed form has no step");
    let steps: f64 = breaks[2].parse().expect("steps to a turn");
    assert!((128.0..180.0).contains(&steps), "{steps}: a whole number of them between samples");
    let turns: f64 = row("lasts")[2].parse().expect("turns");
    assert!(turns > 0.0 && turns < 10.0, "{turns}");
    let output = polhode(folder.path(), &[&asked[..], &["--json"]].concat());
    let rows: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    let runs = rows[0]["cells"][1]["runs"].as_array().expect("runs");
    assert!(runs[1]["energy"]["growth"]["law"].is_string(), "{runs:#?}");
    assert!(runs.iter().all(|run| run["shortest_step_s"].as_f64().is_some_and(|step| step > 0.0)), "{runs:#?}");
}

#[test]
fn stress_refuses_what_it_does_not_know() {
    let folder = tempfile::tempdir().expect("a folder");
    for (flags, words) in [
        (["--cases", "nonesuch"], "no case: take tumbling, "),
        (["--methods", "magic"], "no method: take auto, "),
        (["--plot", "heat.gif"], ".svg or .png"),
    ] {
        let output = polhode(folder.path(), &[&["stress"], &flags[..]].concat());
        assert_eq!(output.status.code(), Some(2), "{flags:?}");
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
    }
}
