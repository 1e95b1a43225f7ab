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
    let matrix: Vec<&str> = text.lines().take(4).collect();
    assert!(matrix.iter().all(|line| line.chars().count() <= 80), "{matrix:#?}");
    assert!(matrix[0].starts_with("quick ") && matrix[0].ends_with("k4"), "{text}");
    assert!(text.contains("0 lost, 0 wrong") || text.contains(" 0 wrong"), "{text}");
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
