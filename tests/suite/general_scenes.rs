//! Scenes with loads that go by a tape of operations: what they tell, and what is refused of them.

use polhode::propagation::{Propagator, States, Taylor};
use polhode::scenario::{Plan, PlannedBody, Scenario, ScenarioError};
use polhode::telemetry::Channel;

fn planned(body: &str) -> Result<PlannedBody, ScenarioError> {
    let text =
        format!("duration_s = 10.0\nsample_every_s = 0.5\n[[body]]\nprincipal_moments_kg_m2 = [1.0, 2.0, 2.5]\n{body}");
    let scenario = Scenario::parse(&text, "scene.toml", &[]).expect("a scene");
    Plan::new(&scenario).map(|mut plan| plan.bodies.remove(0))
}

fn by_formula(text: &str) -> Result<PlannedBody, ScenarioError> {
    planned(&format!("[[body.torque.formula]]\nmoment_n_m = [\"{text}\", \"0\", \"0\"]\nframe = \"body\"\n"))
}

/// A scene may tell the angular momentum in place of the rates: it is the one that is recorded, of the sphere inside too.
#[test]
fn the_angular_momentum_told_is_that_of_body_and_sphere() {
    let body = planned(
        "angular_momentum_n_m_s = [0.4, -0.3, 1.2]\n[[body.torque.inner_sphere]]\ninertia_kg_m2 = 0.5\n\
         coefficient_n_m_s = 0.1\nrelative_rate_rad_s = [1.0, 2.0, -3.0]\n",
    )
    .expect("a plan");
    let samples = body.sample(&[Channel::AngularMomentumBody], &[0.0]).expect("a finite motion");
    let found = samples.channel(Channel::AngularMomentumBody).expect("watched");
    for (found, told) in found.iter().zip([0.4, -0.3, 1.2]) {
        assert!((found[0] - told).abs() < 4e-16, "{} for {told} N m s", found[0]);
    }
}

/// Where one of two is no number, or has no slope, neither is the larger of them: nobody could say when it takes over.
#[test]
fn the_larger_of_a_number_and_none_is_none() {
    for text in ["max(sqrt(t-5), 0.1)", "max(0.1, sqrt(t-5))", "min(ln(-1), 2)", "min(2, ln(-1))", "min(sqrt(t), 1)"] {
        let refused = by_formula(text).expect_err(text).to_string();
        assert!(refused.contains("duration_s") && refused.contains("cannot be propagated"), "{text}: {refused}");
    }
}

/// What overflows is beyond any limit, and stays so.
#[test]
fn a_limit_holds_against_what_overflows() {
    let spin = |text: &str| {
        let body = by_formula(text).expect("a plan");
        let samples = body.sample(&[Channel::AngularVelocity], &[10.0]).expect("a finite motion");
        samples.channel(Channel::AngularVelocity).expect("watched")[0][0]
    };
    assert!((spin("min(exp(1000+t), 0.2)") - spin("0.2")).abs() < 4e-16);
}

/// What cannot go on past a time does not tell of a later step's remains before it either.
#[test]
fn an_error_stays_one() {
    let problem = by_formula("ln(12-t)").expect("a plan").problem;
    let mut taylor = Taylor::new(&problem, 1e-16).expect("covered");
    let mut states = States::default();
    taylor.fill(&[11.0], &mut states).expect("before the pole");
    let first = taylor.fill(&[13.0], &mut states).expect_err("beyond it");
    for time in [11.5, 12.5, 13.0] {
        assert_eq!(taylor.fill(&[time], &mut states).expect_err("an error"), first, "at {time} s");
    }
}
