use std::collections::BTreeMap;

use super::digest::sha256;
use crate::scenario::{Certificate, Plan};

/// Version of what is recorded: topics, entities and what they mean. Adding to it does not change it.
const SCHEMA_VERSION: &str = "1";

/// Begins the names of facts that say what a check has found.
pub const CHECK: &str = "check.";

/// In which units and frames recordings are.
pub fn conventions() -> BTreeMap<String, String> {
    [
        ("schema_version", SCHEMA_VERSION),
        ("units", "SI; drifts in parts per 1e15"),
        ("frames", "world: inertial, right-handed; body/<name>: fixed in the body at its reference point"),
        ("attitude", "unit quaternion, world from body"),
        ("time", "simulated time from the start: stamps in whole ns, and exact in s"),
    ]
    .map(|(name, value)| (name.to_owned(), value.to_owned()))
    .into()
}

/// What makes the recording of `plan`, from what, and how.
pub fn of_plan(plan: &Plan) -> BTreeMap<String, String> {
    let mut facts = conventions();
    let mut tell = |name: String, value: String| facts.insert(name, value);
    tell("polhode_version".into(), env!("CARGO_PKG_VERSION").into());
    tell("scene".into(), plan.name.clone());
    tell("title".into(), plan.title.clone());
    tell("samples".into(), plan.grid.len().to_string());
    for (name, text) in [("scene_sha256", &plan.text), ("identity_sha256", &plan.identity)] {
        if let Some(hash) = sha256(text) {
            tell(name.into(), hash);
        }
    }
    for (number, outcome) in plan.outcomes.iter().enumerate() {
        tell(format!("{CHECK}{:03}", number + 1), outcome.in_words());
    }
    for body in &plan.bodies {
        tell(format!("body.{}.method", body.name), body.path.name().into());
        tell(format!("body.{}.reason", body.name), body.reason.clone());
        for (name, value) in body.certificate.iter().flat_map(Certificate::facts) {
            tell(format!("body.{}.certificate.{name}", body.name), value);
        }
    }
    facts
}

/// What facts about a recording say of the error of one of its bodies.
pub fn certificate(facts: &[(String, String)], body: &str) -> Vec<(String, String)> {
    let prefix = format!("body.{body}.certificate.");
    let told = facts.iter().filter_map(|(name, value)| Some((name.strip_prefix(&prefix)?.to_owned(), value.clone())));
    told.collect()
}
