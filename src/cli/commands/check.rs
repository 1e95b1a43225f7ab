use std::io;

use serde_json::{Value, json};

use crate::cli::args::CheckArguments;
use crate::cli::execute::{Outcome, scenario_or_faults};
use crate::cli::output::{print, print_json, remark};
use crate::cli::report::sampling;
use crate::cli::table::Table;
use crate::plot::grouped;
use crate::propagation::PropagationError;
use crate::scenario::{Cost, Plan, Refused, ScenarioError};

/// Holds scenes to every rule without running them, and says by which path and at what cost each body would go.
pub fn execute(arguments: &CheckArguments) -> io::Result<Outcome> {
    let mut outcome = Outcome::Done;
    let mut values = Vec::new();
    for name in &arguments.scenes {
        let found = scenario_or_faults(name, &arguments.set)
            .and_then(|scenario| Plan::new_all(&scenario))
            .and_then(|plan| costs(&plan).map(|costs| (plan, costs)).map_err(|error| vec![error.into()]));
        match found {
            Ok((plan, costs)) if arguments.json => values.push(as_json(name, &plan, &costs)),
            Ok((plan, costs)) => print(&as_text(name, &plan, &costs))?,
            Err(faults) => {
                outcome = Outcome::Impossible;
                values.push(json!({
                    "scene": name, "is_sound": false, "faults": faults.iter().map(fault).collect::<Vec<_>>(),
                }));
                for fault in &faults {
                    remark(&format!("error: {fault}"));
                }
            }
        }
    }
    if arguments.json {
        print_json(&Value::Array(values))?;
    }
    Ok(outcome)
}

fn costs(plan: &Plan) -> Result<Vec<Cost>, PropagationError> {
    plan.bodies.iter().map(|body| body.cost(&plan.grid)).collect()
}

fn as_text(name: &str, plan: &Plan, costs: &[Cost]) -> String {
    let mut table = Table::default();
    for (body, cost) in plan.bodies.iter().zip(costs) {
        table.row([body.name.clone(), format!("{}: {}", body.path.name(), body.reason)]);
        table.row([String::new(), in_words(*cost)]);
    }
    table.row(["samples".to_owned(), sampling(&plan.grid)]);
    table.row(["checks".to_owned(), plan.checks.len().to_string()]);
    format!("{name}: sound\n{}", table.render("  "))
}

fn in_words(cost: Cost) -> String {
    match cost {
        Cost { steps: 0, samples, .. } => format!("{} evaluations, no steps", grouped(samples)),
        Cost { steps, is_estimate: true, .. } => format!("about {} steps", grouped(steps)),
        Cost { steps, .. } => format!("{} steps", grouped(steps)),
    }
}

fn as_json(name: &str, plan: &Plan, costs: &[Cost]) -> Value {
    let bodies: Vec<_> = plan
        .bodies
        .iter()
        .zip(costs)
        .map(|(body, cost)| {
            json!({
                "name": body.name,
                "path": body.path.name(),
                "reason": body.reason,
                "steps": cost.steps,
                "steps_are_an_estimate": cost.is_estimate,
            })
        })
        .collect();
    json!({
        "scene": name,
        "is_sound": true,
        "title": plan.title,
        "samples": plan.grid.len(),
        "end_s": plan.grid.end(),
        "bodies": bodies,
        "checks": plan.checks.len(),
    })
}

fn fault(fault: &ScenarioError) -> Value {
    match fault {
        ScenarioError::Refused(refused) => {
            let Refused { file, key, message, excerpt } = refused.as_ref();
            let place = excerpt.as_ref().map(|excerpt| (excerpt.line, excerpt.column));
            json!({
                "file": file, "line": place.map(|place| place.0), "column": place.map(|place| place.1),
                "key": key, "message": message,
            })
        }
        other => json!({ "message": other.to_string() }),
    }
}
