use polhode::scenario::{Plan, Scenario};

use super::scenes::{Validator, as_json, at, parsed, places, sound};

/// What plans say after a number that they refuse by its size alone.
const OF_RANGES: [&str; 2] = ["must be positive and finite", "must be finite and not negative"];

/// Ranges: every number of every scene in turn is made 0 and negative.
#[test]
fn ranges_of_the_schema_are_those_of_the_plan() {
    let validator = Validator::new();
    let (mut held, mut tried) = (0, 0);
    for (name, text) in sound() {
        let scene = parsed(&text).expect("TOML");
        for place in places(&scene) {
            if !matches!(at(&mut scene.clone(), &place), toml::Value::Integer(_) | toml::Value::Float(_)) {
                continue;
            }
            for number in [0.0, -1.0] {
                let mut changed = scene.clone();
                *at(&mut changed, &place) = number.into();
                let (by_schema, by_plan) = (validator.refusal(&as_json(&changed)), refusal(&changed, &name));
                tried += 1;
                if let (Some(why), None) = (&by_schema, &by_plan) {
                    panic!("{name}: the schema refuses {place:?} = {number}, and the plan does not: {why}");
                }
                let is_of_range =
                    |message: &String| OF_RANGES.iter().any(|rule| message.contains(&format!(": {number:?} {rule}")));
                if by_plan.as_ref().is_some_and(is_of_range) {
                    assert!(by_schema.is_some(), "{name}: the schema takes {place:?} = {number}: {by_plan:?}");
                    held += 1;
                }
            }
        }
    }
    assert!(held > 100 && tried > 1000, "{held} of {tried}");
}

fn refusal(scene: &toml::Value, name: &str) -> Option<String> {
    let text = toml::to_string(scene).expect("TOML");
    let plan = Scenario::parse(&text, name, &[]).and_then(|scenario| Plan::new(&scenario));
    plan.err().map(|error| error.to_string())
}
