//! Probes and IMUs: points of a body that are recorded beside it.

use polhode::scenario::{Plan, Scenario};
use polhode::telemetry::BodySamples;

mod motion;
mod recordings;

/// The plan of a scene.
fn plan(text: &str) -> Plan {
    let scenario = Scenario::parse(text, "probes.toml", &[]).expect("a scene");
    Plan::new(&Scenario { name: "probes".into(), ..scenario }).expect("a plan")
}

/// What is recorded under `name`, all of it.
fn recorded(plan: &Plan, name: &str) -> BodySamples {
    let number = plan.watched().position(|watched| watched.name() == name).expect("it is recorded");
    let mut all: Option<BodySamples> = None;
    let mut run = plan.start().expect("a motion");
    while let Some(samples) = run.next_batch().expect("finite states") {
        let batch = &samples.bodies[number];
        match &mut all {
            None => all = Some(batch.clone()),
            Some(all) => {
                for (column, next) in all.columns_mut().iter_mut().zip(batch.columns()) {
                    column.extend_from_slice(next);
                }
            }
        }
    }
    all.expect("a sample")
}
