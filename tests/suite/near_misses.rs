//! Names that are not known: messages name the one that was likely meant, wherever a name can be mistyped.

use polhode::scenario::{Plan, Scenario};

const SCENE: &str = "
duration_s = 1
sample_every_s = 0.5

[[body]]
name = \"slab\"
principal_moments_kg_m2 = [1, 2, 2.5]
angular_velocity_rad_s = [0, 0, 1]
";

fn faults(addition: &str) -> Vec<String> {
    let scene = format!("{}\n{}", addition.split("---").next().unwrap_or_default(), SCENE);
    let scene = scene + addition.split("---").nth(1).unwrap_or_default();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, scene).expect("room");
    let found = Scenario::read_all(&path, &[]).and_then(|scenario| Plan::new_all(&scenario));
    found.err().unwrap_or_default().iter().map(ToString::to_string).collect()
}

#[test]
fn near_misses_are_named_everywhere() {
    for (addition, words) in [
        ("sumary = \"x\"---", "sumary: no such key; did you mean `summary`?"),
        ("metod = \"rk4\"---", "metod: no such key; did you mean `method`?"),
        ("method = \"tailor\"---", "method: \"tailor\" is not known; did you mean `taylor`?"),
        ("channels = [\"atitude\"]---", "channels[0]: \"atitude\" is no channel; did you mean \"attitude\"?"),
        ("---mas_kg = 1", "body[0].mas_kg: no such key; did you mean `mass_kg`?"),
        ("---angular_velocity = [0, 0, 1]", "did you mean `angular_velocity_rad_s`?"),
        ("---[body.pivott]", "body[0].pivott: no such key; did you mean `pivot`?"),
        ("---[[body.torque.damping]]", "body[0].torque.damping: no such key; did you mean `linear_damping`?"),
        ("---[[body.force.constant_wrold]]", "did you mean `constant_world`?"),
        ("---[[body.solid.cilinder]]", "body[0].solid.cilinder: no such key; did you mean `cylinder`?"),
        ("---[[check.flip_periods]]", "check.flip_periods: no such key; did you mean `flip_period`?"),
        (
            "---[[check.energy]]\ntolerance = 1\nbdy = \"slab\"",
            "check.energy[0].bdy: no such key; did you mean `body`?",
        ),
        ("---[[check.energy]]\ntolerance = 1\nbody = \"slap\"", "is no body of this scene; did you mean \"slab\"?"),
        ("---[provenence]", "provenence: no such key; did you mean `provenance`?"),
    ] {
        let found = faults(addition);
        assert!(found.len() == 1 && found[0].contains(words), "{addition}: {found:?}");
    }
    let unknown = Scenario::named("dzhanibekof", &[]).expect_err("no such scene").to_string();
    assert!(unknown.contains("did you mean \"dzhanibekov\"?"), "{unknown}");
}

/// Where nothing is near, what there is.
#[test]
fn names_are_listed_where_none_is_near() {
    let found = faults("---[[body.solid.pyramid]]");
    assert!(found[0].contains("no such key; here are `box`, `cylinder`"), "{found:?}");
}

#[test]
fn every_fault_of_a_scene_is_told_in_one_go() {
    let text = "
durations_s = 1
sample_every_s = \"often\"

[[body]]
mas_kg = 1
principal_moments_kg_m2 = [1, 2]

[[body.torque.linear_damping]]
start_s = 1

[[check.energi]]
tolerance = 1
";
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("room");
    let found: Vec<_> = Scenario::read_all(&path, &[]).expect_err("faults").iter().map(ToString::to_string).collect();
    let expected = [
        "durations_s: no such key",
        "sample_every_s: invalid type",
        "body[0].mas_kg: no such key",
        "body[0].principal_moments_kg_m2: invalid length 2",
        "body[0].torque.linear_damping[0].coefficient_n_m_s: missing",
        "check.energi: no such key",
    ];
    assert_eq!(found.len(), expected.len(), "{found:#?}");
    for words in expected {
        assert!(found.iter().any(|fault| fault.contains(words) && fault.contains('^')), "{words}: {found:#?}");
    }
}

#[test]
fn every_body_that_is_refused_is_told() {
    let text = "
duration_s = 1
sample_every_s = 0.5
[[body]]
name = \"a\"
principal_moments_kg_m2 = [1, 2, 9]
[[body]]
name = \"b\"
principal_moments_kg_m2 = [1, 2, 2.5]
[[body]]
name = \"c\"
principal_moments_kg_m2 = [1, 2, 2.5]
attitude = [1, 1, 0, 0]
";
    let scenario = Scenario::parse(text, "scene.toml", &[]).expect("names and types are right");
    let found: Vec<_> = Plan::new_all(&scenario).expect_err("faults").iter().map(ToString::to_string).collect();
    assert_eq!(found.len(), 2, "{found:#?}");
    assert!(
        found[0].contains("body[0].principal_moments_kg_m2") && found[1].contains("body[2].attitude"),
        "{found:#?}"
    );
    assert_eq!(Plan::new(&scenario).expect_err("the first").to_string(), found[0]);
}

fn sixty(part: impl Fn(u32) -> String) -> String {
    (0..60).map(part).collect()
}

/// A file that is no scene at all is not answered with a page for each of its lines.
#[test]
fn no_more_than_fifty_faults_are_told() {
    let head = "duration_s = 1\nsample_every_s = 0.5\n";
    let unknown = sixty(|n| format!("zzzz{n} = 1\n"));
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, unknown + head).expect("room");
    assert_eq!(Scenario::read_all(&path, &[]).expect_err("faults").len(), 50);
    let bodies = sixty(|n| format!("[[body]]\nname = \"b{n}\"\nprincipal_moments_kg_m2 = [1, 2, 9]\n"));
    let scenario = Scenario::parse(&(head.to_owned() + &bodies), "scene.toml", &[]).expect("names and types are right");
    assert_eq!(Plan::new_all(&scenario).expect_err("faults").len(), 50);
}
