use std::io;

use serde_json::{Value, json};

use crate::cli::args::PlanArguments;
use crate::cli::execute::{Outcome, scenario};
use crate::cli::output::{print, print_json, remark};
use crate::cli::report::sampling;
use crate::cli::table::Table;
use crate::scenario::{Path, Plan};
use crate::telemetry::{Channel, Point};

/// Shows how scenes would be run.
pub fn execute(arguments: &PlanArguments) -> io::Result<Outcome> {
    let assignments = arguments.overrides.assignments();
    let mut outcome = Outcome::Done;
    let mut values = Vec::new();
    for name in &arguments.scenes {
        match scenario(name, &assignments).and_then(|scenario| Plan::new(&scenario)) {
            Ok(plan) if arguments.json => values.push(as_json(&plan)),
            Ok(plan) => print(&as_text(&plan))?,
            Err(error) => {
                remark(&format!("error: {error}"));
                outcome = Outcome::Impossible;
            }
        }
    }
    if arguments.json {
        print_json(&Value::Array(values))?;
    }
    Ok(outcome)
}

fn as_text(plan: &Plan) -> String {
    let mut text = format!("{}: {}\n", plan.name, plan.title);
    let mut table = Table::default();
    table.row(["samples".to_owned(), sampling(&plan.grid)]);
    for body in &plan.bodies {
        table.row(["body".to_owned(), body.name.clone()]);
        table.row(["  path".to_owned(), format!("{}{}: {}", body.path.name(), setting(body.path), body.reason)]);
        let [a, b, c]: [f64; 3] = body.properties.moments.vector().into();
        table.row(["  moments".to_owned(), format!("{a}, {b}, {c} kg m²")]);
        if let Some(mass) = body.properties.mass {
            table.row(["  mass".to_owned(), format!("{mass} kg")]);
        }
        table.row(["  records".to_owned(), names(&body.channels).join(", ")]);
        for point in &body.points {
            table.row([format!("  {}", point.name), names(&point.channels).join(", ")]);
        }
        for (index, skipped) in body.skipped.iter().enumerate() {
            table.row([if index == 0 { "  skips" } else { "" }.to_owned(), skipped.clone()]);
        }
    }
    for (index, event) in plan.events.iter().enumerate() {
        let words = format!("{} s: {}: {}", event.time_s, plan.bodies[event.body].name, event.text);
        table.row([if index == 0 { "events" } else { "" }.to_owned(), words]);
    }
    table.row(["checks".to_owned(), plan.checks.len().to_string()]);
    text.push_str(&table.render("  "));
    text
}

/// What the path is told of each step.
fn setting(path: Path) -> String {
    match path {
        Path::Taylor { tolerance } | Path::Dop853 { tolerance } => format!(", {tolerance:.1e} rad a step"),
        Path::FixedStep { step, .. } => format!(", steps of {step} s"),
        _ => String::new(),
    }
}

fn names(channels: &[Channel]) -> Vec<&'static str> {
    channels.iter().map(|channel| channel.row().name).collect()
}

fn as_json(plan: &Plan) -> Value {
    let bodies: Vec<_> = plan
        .bodies
        .iter()
        .map(|body| {
            let step_tolerance = match body.path {
                Path::Taylor { tolerance } | Path::Dop853 { tolerance } => Some(tolerance),
                _ => None,
            };
            let point = |point: &Point| json!({ "name": point.name, "channels": names(&point.channels) });
            let points: Vec<_> = body.points.iter().map(point).collect();
            json!({
                "name": body.name,
                "path": body.path.name(),
                "reason": body.reason,
                "step_tolerance_rad": step_tolerance,
                "mass_kg": body.properties.mass,
                "principal_moments_kg_m2": body.properties.moments.vector().as_slice(),
                "channels": names(&body.channels),
                "points": points,
                "skipped": body.skipped,
            })
        })
        .collect();
    json!({
        "name": plan.name,
        "title": plan.title,
        "samples": plan.grid.len(),
        "end_s": plan.grid.end(),
        "tolerance_rad": plan.tolerance_rad,
        "bodies": bodies,
        "checks": plan.checks.len(),
    })
}
