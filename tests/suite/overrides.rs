//! `--set` reaches every key of a scene, under the rules of the file, and says what is meant where it does not.

use polhode::scenario::{Plan, Scenario, ScenarioError};

const SCENE: &str = "
duration_s = 1
sample_times_s = [0, 0.5, 1]

[[body]]
name = \"a\"
inertia_kg_m2 = [[1, 0, 0], [0, 2, 0], [0, 0, 2.5]]
pivot = { position_m = [0, 0, 0] }

[[body.torque.constant_body]]
moment_n_m = [0, 0, 1]

[[body.torque.constant_body]]
moment_n_m = [0, 1, 0]

[[body]]
name = \"b\"
particle = [{ mass_kg = 1, position_m = [1, 0, 0] }, { mass_kg = 1, position_m = [0, 1, 0] }]
";

fn set(overrides: &[&str]) -> Result<Scenario, ScenarioError> {
    let overrides: Vec<_> = overrides.iter().map(|each| (*each).to_owned()).collect();
    Scenario::parse(SCENE, "scene.toml", &overrides)
}

fn changed(overrides: &[&str]) -> Scenario {
    set(overrides).unwrap_or_else(|error| panic!("{overrides:?}: {error}"))
}

fn refused(assignment: &str) -> String {
    set(&[assignment]).expect_err(assignment).to_string()
}

#[test]
fn elements_of_lists_are_reached_by_number_however_deep() {
    let scene = changed(&[
        "sample_times_s.1=0.25",
        "body.0.inertia_kg_m2.2.2=2.75",
        "body.0.torque.constant_body.1.moment_n_m.0=7",
        "body.1.particle.1.position_m.2=-3",
        "body.1.name=c",
    ]);
    assert_eq!(scene.sample_times_s, Some(vec![0.0, 0.25, 1.0]));
    assert_eq!(scene.body[0].inertia_kg_m2.map(|tensor| tensor[2][2]), Some(2.75));
    assert_eq!(scene.body[0].torque.constant_body[1].moment_n_m, [7.0, 1.0, 0.0]);
    assert_eq!(scene.body[1].particle[1].position_m, [0.0, 1.0, -3.0]);
    assert_eq!(scene.body[1].name, "c");
}

#[test]
fn what_is_not_there_yet_is_begun() {
    let scene = changed(&[
        "provenance.source=somebody",
        "body.0.mass_kg=2",
        "body.0.force.constant_world.0.force_n=[0, 0, 1]",
        "body.0.force.constant_world.0.point_m=[1, 0, 0]",
        "body.0.pivot.inertia_about_pivot=true",
        "check.value.0.channel=tilt",
        "check.value.0.time_s=0",
        "check.value.0.expected=0",
        "check.value.0.tolerance=1",
        "channels.0=attitude",
        "body.1.pivot.position_m=[0, 0, 1]",
    ]);
    assert_eq!(scene.provenance.source, "somebody");
    assert_eq!(scene.body[0].force.constant_world[0].point_m, [1.0, 0.0, 0.0]);
    assert_eq!(scene.body[0].pivot.as_ref().map(|pivot| pivot.inertia_about_pivot), Some(true));
    assert_eq!(scene.check.value[0].channel, "tilt");
    assert_eq!(scene.channels.as_deref(), Some(&["attitude".to_owned()][..]));
    assert_eq!(scene.body[1].pivot.as_ref().map(|pivot| pivot.position_m), Some([0.0, 0.0, 1.0]));
}

#[test]
fn a_plus_adds_to_the_end_of_a_list() {
    let scene = changed(&[
        "sample_times_s.+=2",
        "body.0.torque.constant_body.+.moment_n_m=[5, 0, 0]",
        "body.0.torque.constant_body.2.end_s=0.5",
        "body.0.torque.constant_world.+={ moment_n_m = [0, 0, 3] }",
        "body.1.particle.+.mass_kg=3",
        "body.1.particle.2.position_m=[0, 0, 1]",
        "body.+.name=c",
        "body.2.principal_moments_kg_m2=[1, 1, 1]",
    ]);
    assert_eq!(scene.sample_times_s, Some(vec![0.0, 0.5, 1.0, 2.0]));
    let added = &scene.body[0].torque.constant_body[2];
    assert_eq!((added.moment_n_m, added.end_s), ([5.0, 0.0, 0.0], Some(0.5)));
    assert_eq!(scene.body[0].torque.constant_world[0].moment_n_m, [0.0, 0.0, 3.0]);
    assert_eq!(scene.body[1].particle[2].mass_kg, 3.0);
    assert_eq!(scene.body[2].name, "c");
}

#[test]
fn whole_tables_and_lists_can_be_replaced() {
    let scene = changed(&["body.1={ name = \"c\", principal_moments_kg_m2 = [1, 1, 1] }", "sample_times_s=[0, 1]"]);
    assert_eq!((scene.body[1].name.as_str(), scene.body[1].particle.len()), ("c", 0));
    let scene = changed(&["body.0.torque={}"]);
    assert!(scene.body[0].torque.constant_body.is_empty());
}

#[test]
fn rules_are_those_of_the_file() {
    for (assignment, rule) in [
        ("body.0.mass_kg=-1", "body[0].mass_kg: -1.0 must be positive"),
        ("body.0.mass_kg=heavy", "body[0].mass_kg: invalid type: string \"heavy\""),
        ("body.0.torque.constant_body.1.end_s=-2", "body[0].torque.constant_body[1].end_s: -2.0 must be positive"),
        ("channels=[\"tild\"]", "did you mean \"tilt\"?"),
        ("method=rk5", "method: \"rk5\" is not known; did you mean `rk4`?"),
        ("durations_s=3", "durations_s: no such key; did you mean `duration_s`?"),
        ("body.0.torqe.constant_body.0.moment_n_m=[0, 0, 1]", "body[0].torqe: no such key; did you mean `torque`?"),
        ("body.0.torque.constant_bdy.0.moment_n_m=[0, 0, 1]", "did you mean `constant_body`?"),
        ("bodies.0.mass_kg=1", "bodies: no such key; did you mean `body`?"),
        ("body.0.particle.0.mass_kg=1", "missing"),
    ] {
        let found = set(&[assignment]).and_then(|scene| Plan::new(&scene)).expect_err(assignment).to_string();
        assert!(found.starts_with("scene.toml (with --set):") && found.contains(rule), "{assignment}: {found}");
    }
}

#[test]
fn paths_that_lead_nowhere_are_told_where_they_end() {
    for (assignment, words) in [
        ("body.2.mass_kg=1", "there is no body.2: body has body.0 to body.1; body.+ adds one"),
        ("body.0.force.constant_world.1.force_n=[0, 0, 1]", "body.0.force.constant_world.0 begins it"),
        ("sample_times_s.3=1", "there is no sample_times_s.3: sample_times_s has sample_times_s.0 to sample_times_s.2"),
        ("body.mass_kg=1", "body is a list: body.0.mass_kg, by the element's number (0 to 1)"),
        ("body[0].mass_kg=1", "\"body[0]\": elements are told by dots: body.0"),
        ("duration_s.0=1", "duration_s is no list"),
        ("duration_s.x=1", "duration_s is no table, and has no \"x\""),
        ("0=1", "the scene is no list"),
        ("body.0=1", "body.0 is a table"),
        ("body..mass_kg=1", "a part of the key is empty"),
        ("duration_s", "an override reads key=value"),
        ("sample_times_s=[0, 1", "[0, 1 is no TOML"),
    ] {
        let found = refused(assignment);
        assert!(found.starts_with("scene.toml: ") && found.contains(words), "{assignment}: {found}");
    }
    let deep = format!("{}=1", "a.".repeat(100_000) + "a");
    assert!(refused(&deep).contains("more than 20 parts"), "no stack is deep enough for every path");
}
