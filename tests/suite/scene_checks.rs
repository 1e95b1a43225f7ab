//! What each kind of check measures, on motions whose numbers are known by heart, and that it fails where it must.

use std::f64::consts::TAU;

use polhode::scenario::{CheckOutcome, Plan, Scenario};

/// ω goes round axis 3 at 3 rad/s, the axis round L at √(0.5² + 6²) rad/s.
const WHEEL: &str = "[[body]]\nprincipal_moments_kg_m2 = [1, 1, 2]\nangular_velocity_rad_s = [0.5, 0, 3]\n";

fn measured(body: &str, checks: &str) -> Vec<CheckOutcome> {
    let text = format!("duration_s = 12\nsample_every_s = 4\n{body}{checks}");
    let scenario = Scenario::parse(&text, "checks.toml", &[]).unwrap_or_else(|error| panic!("{error}"));
    let plan = Plan::new(&scenario).unwrap_or_else(|error| panic!("{error}"));
    plan.measure_checks().expect("a motion without end")
}

fn check(body: &str, kind: &str, keys: &str) -> CheckOutcome {
    measured(body, &format!("[[check.{kind}]]\n{keys}\n")).remove(0)
}

/// The run has four samples: none of these could be counted in them.
#[test]
fn periods_are_located_on_the_motion() {
    let period = TAU / 3.0;
    for (quantity, cycles, limit) in [
        ("channel = \"angular_velocity\"\ncomponent = \"x\"", 1, 1e-15),
        ("channel = \"angular_velocity\"\ncomponent = \"y\"\nlevel = 0.3", 4, 2e-15),
        ("channel = \"polhode_phase\"", 1, 1e-15),
        ("channel = \"polhode_phase\"\nlevel = 3.1", 100, 2e-15),
    ] {
        let keys = format!("{quantity}\ncycles = {cycles}\nexpected_s = 2.1\ntolerance_s = 0.1");
        let found = check(WHEEL, "period", &keys);
        assert!(found.passed && (found.measured / period - 1.0).abs() < limit, "{quantity}: {}", found.measured);
    }
}

#[test]
fn a_period_that_never_comes_fails() {
    let level = "channel = \"angular_velocity\"\ncomponent = \"x\"\nlevel = 0.6\nexpected_s = 2\ntolerance_s = 1";
    let found = check(WHEEL, "period", level);
    assert!(found.measured.is_nan() && !found.passed);
    // Crossings a hundred times as far apart as expected are not found either.
    let rare = "channel = \"angular_velocity\"\ncomponent = \"x\"\nexpected_s = 0.02\ntolerance_s = 10";
    assert!(!check(WHEEL, "period", rare).passed);
}

#[test]
fn rates_count_whole_turns() {
    let precession = 36.25_f64.sqrt();
    for (component, rate) in [("precession", precession), ("spin", -3.0)] {
        let keys = format!(
            "channel = \"figure_angles\"\ncomponent = \"{component}\"\nexpected_rad_s = {rate:?}\ntolerance_rad_s = 1e-14"
        );
        let found = check(WHEEL, "rate", &keys);
        assert!(found.passed, "{component}: {} for {rate}", found.measured);
    }
    let wrong = "channel = \"figure_angles\"\ncomponent = \"spin\"\nexpected_rad_s = 3\ntolerance_rad_s = 1";
    assert!(!check(WHEEL, "rate", wrong).passed);
}

#[test]
fn extrema_are_located_within_their_span() {
    for (extremum, span, expected) in [
        ("greatest", "", 0.5_f64),
        ("least", "", -0.5),
        // Half a turn on, and between the ends of a quarter turn.
        ("greatest", "from_s = 0.1\nto_s = 0.5", 0.5 * libm::cos(0.3)),
        ("least", "from_s = 0.6\nto_s = 1.3", -0.5),
    ] {
        let keys = format!(
            "channel = \"angular_velocity\"\ncomponent = \"x\"\nextremum = \"{extremum}\"\n{span}\n\
             expected = {expected:?}\ntolerance = 1e-15"
        );
        let found = check(WHEEL, "extremum", &keys);
        assert!(found.passed, "{extremum} {span}: {}", found.measured);
    }
}

#[test]
fn what_changes_is_not_conserved() {
    assert!(check(WHEEL, "conserved", "channel = \"momentum_tilt\"\ntolerance = 1e-14").passed);
    let found = check(WHEEL, "conserved", "channel = \"angular_velocity\"\ncomponent = \"x\"\ntolerance = 1");
    // From 0.5 to −0.5, of 0.5.
    assert!(!found.passed && (found.measured - 2.0).abs() < 1e-3, "{}", found.measured);
}

/// The axis goes round L in a cone of half angle atan(0.5/6): it is off its start by up to twice that.
#[test]
fn axes_stay_or_leave() {
    let far = 2.0 * libm::atan(0.5 / 6.0);
    for (angle, verdict, passes) in [
        (far + 1e-5, "stays", true),
        (far - 1e-5, "stays", false),
        (far - 1e-5, "leaves", true),
        (far + 1e-5, "leaves", false),
    ] {
        let keys = format!("axis = [0, 0, 1]\nangle_rad = {angle:?}\nverdict = \"{verdict}\"");
        let found = check(WHEEL, "stability", &keys);
        assert!(found.passed == passes && (found.measured - far).abs() < 1e-6, "{verdict} {angle}: {}", found.measured);
    }
    // From where it never is: from behind.
    let behind = "axis = [0, 0, 1]\nnear = [0, 0, -1]\nangle_rad = 3\nverdict = \"leaves\"";
    assert!(check(WHEEL, "stability", behind).passed);
}

#[test]
fn a_body_that_does_not_come_round_has_no_montgomery_phase() {
    let steady = "[[body]]\nprincipal_moments_kg_m2 = [1, 2, 2.5]\nangular_velocity_rad_s = [0, 0, 3]\n";
    let keys = "period_s = 2\nexpected_rad = 1\ntolerance_rad = 7";
    assert!(!check(steady, "montgomery_phase", keys).passed);
    let book = "[[body]]\nprincipal_moments_kg_m2 = [97, 82, 17]\nangular_velocity_rad_s = [0.1, 5, 0.1]\n";
    let phase = 4.366_086_281_284_775;
    for (whole, passes) in [(0.0, true), (3.0, true), (0.01, false)] {
        let keys = format!("period_s = 6\nexpected_rad = {:?}\ntolerance_rad = 1e-12", phase + whole * TAU);
        assert_eq!(check(book, "montgomery_phase", &keys).passed, passes, "{whole}");
    }
}

/// What the world says is told; it is judged only where that is asked for.
#[test]
fn observations_are_told_and_judged_if_asked() {
    let keys = |tolerance: &str| {
        format!(
            "channel = \"polhode_phase\"\nexpected_s = 2.0943951023931953\ntolerance_s = 1e-12\n\
             observed = {{ published = 3, uncertainty = 0.25{tolerance} }}"
        )
    };
    let told = check(WHEEL, "period", &keys(""));
    assert!(told.passed);
    let words = told.in_words();
    assert!(words.contains("observed 3.0 ± 0.25 (off by -9.056e-1)") && words.ends_with(": passed"), "{words}");
    assert!(check(WHEEL, "period", &keys(", tolerance = 1")).passed);
    assert!(!check(WHEEL, "period", &keys(", tolerance = 0.5")).passed);
}
