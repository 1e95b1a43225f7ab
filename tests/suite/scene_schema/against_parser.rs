use std::collections::BTreeSet;

use polhode::scenario::Scenario;

use super::scenes::{Validator, as_json, at, bad, parsed, places, sound};
use super::tables::Table;

#[test]
fn every_scene_that_runs_is_a_scene_of_the_schema() {
    let validator = Validator::new();
    let scenes = sound();
    assert!(scenes.len() >= 25, "{} scenes", scenes.len());
    for (name, text) in scenes {
        let scene = parsed(&text).unwrap_or_else(|| panic!("{name} is TOML"));
        assert_eq!(validator.refusal(&as_json(&scene)), None, "{name}");
    }
}

/// The parser says what it knows where it is asked for a key that it does not know.
#[test]
fn parser_and_schema_know_the_same_keys_of_every_table() {
    let tables = Table::all();
    assert!(tables.len() >= 25, "{} tables", tables.len());
    for table in tables {
        let of_schema: BTreeSet<_> = table.keys.iter().map(|key| key.name.clone()).collect();
        let of_parser: BTreeSet<_> = table.keys_of_parser().into_iter().collect();
        assert_eq!(of_schema, of_parser, "{}", table.path);
        assert!(table.keys.iter().all(|key| !key.description().is_empty()), "{}: each key has words", table.path);
        assert!(table.keys.iter().all(|key| key.schema["format"].is_null()), "{}: TOML has no formats", table.path);
    }
}

/// In every table: an unknown key, and a value of another type.
#[test]
fn schema_refuses_what_the_parser_refuses_of_keys_and_types() {
    let validator = Validator::new();
    for (name, text) in sound() {
        let scene = parsed(&text).expect("TOML");
        for place in places(&scene) {
            let mut changed = scene.clone();
            let value = at(&mut changed, &place);
            match value {
                toml::Value::Table(table) => drop(table.insert("zzzz".to_owned(), 1.into())),
                toml::Value::Boolean(_) => *value = "yes".into(),
                _ => *value = true.into(),
            }
            assert!(validator.refusal(&as_json(&changed)).is_some(), "{name}: {place:?}");
            let text = toml::to_string(&changed).expect("TOML");
            assert!(Scenario::parse(&text, &name, &[]).is_err(), "{name}: {place:?}");
        }
    }
}

/// What breaks a rule of structure: keys, types, ranges, what excludes or needs what. The rest only a plan can tell.
const STRUCTURAL: &[&str] = &[
    "bodies_without_names",
    "channel_twice",
    "check_before_start",
    "check_observed_without_uncertainty",
    "check_of_unknown_channel",
    "check_of_unknown_extremum",
    "check_period_of_no_cycle",
    "check_stability_beyond_pi",
    "check_without_tolerance",
    "empty_times",
    "endless_duration",
    "interval_below_nanosecond",
    "mass_beside_solids",
    "massless_particle",
    "missing_check_key",
    "name_with_slash",
    "negative_brake",
    "negative_damping",
    "negative_duration",
    "negative_mass",
    "negative_moment",
    "negative_radius",
    "negative_step",
    "negative_time",
    "no_body",
    "no_channels",
    "no_duration",
    "no_inertia",
    "no_sampling",
    "probe_in_unknown_frame",
    "probe_misspelt_key",
    "probe_name_with_slash",
    "probe_without_name",
    "rate_and_momentum",
    "rk4_without_step",
    "solid_with_mass_and_density",
    "solid_without_density",
    "step_without_fixed_step",
    "tolerance_of_fixed_step",
    "tolerance_too_loose",
    "tolerance_too_tight",
    "two_components",
    "two_inertias",
    "two_samplings",
    "unknown_body_key",
    "unknown_channel",
    "unknown_check",
    "unknown_key",
    "unknown_method",
    "unknown_solid_kind",
    "unknown_torque_key",
    "unknown_torque_kind",
    "unused_solid_key",
    "velocity_with_pivot",
    "window_before_start",
    "wrong_type",
    "zero_interval",
    "zero_mean_motion",
    "zero_moment",
];

#[test]
fn schema_refuses_bad_scenes_whose_fault_is_one_of_structure() {
    let validator = Validator::new();
    let scenes = bad();
    for name in STRUCTURAL {
        let (_, text) = scenes.iter().find(|(file, _)| file.trim_end_matches(".toml") == *name).expect("a bad scene");
        let scene = parsed(text).expect("TOML");
        assert!(validator.refusal(&as_json(&scene)).is_some(), "the schema takes {name}");
    }
}
