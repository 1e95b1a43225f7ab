use std::fmt::Write as _;

use re_sdk_types::archetypes::{TextDocument, TextLog};
use re_sdk_types::components::TextLogLevel;

use super::trail::Cut;
use crate::recording::picture::Picture;
use crate::scenario::{Plan, PlannedBody};
use crate::telemetry::Channel;

/// The scene in words: what it is, what to see, what was done, where it comes from.
pub(super) fn document(plan: &Plan, picture: &Picture) -> TextDocument {
    let mut text = format!("### {}\n\n{}\n\n", plan.title, plan.summary);
    text += &legend(plan, picture);
    text += "\n#### Bodies\n\n";
    text += "| body | mass (kg) | principal moments (kg m²) | method | because |\n|---|---|---|---|---|\n";
    for body in &plan.bodies {
        text += &row(body);
    }
    text += &checks(plan);
    text += &certificates(plan);
    text += &provenance(plan);
    let _ = writeln!(text, "\nScene `{}`, recorded by polhode {}.", plan.name, env!("CARGO_PKG_VERSION"));
    TextDocument::from_markdown(text)
}

/// What happens to the bodies, in the order of the plan.
pub(super) fn events(plan: &Plan) -> TextLog {
    let texts = plan.events.iter().map(|event| match plan.bodies.get(event.body) {
        Some(body) if plan.bodies.len() > 1 => format!("{}: {}", body.name, event.text),
        _ => event.text.clone(),
    });
    let levels = plan.events.iter().map(|_| TextLogLevel::from(TextLogLevel::INFO));
    TextLog::update_fields().with_many_text(texts).with_many_level(levels)
}

/// What the colours and lengths mean.
fn legend(plan: &Plan, picture: &Picture) -> String {
    let mut text = String::new();
    for (body, drawing) in plan.bodies.iter().zip(&picture.bodies) {
        if drawing.arrows.is_empty() {
            continue;
        }
        let owner = if plan.bodies.len() > 1 { format!(" of {}", body.name) } else { String::new() };
        let labels: Vec<_> = drawing.arrows.iter().map(|arrow| arrow.label.as_str()).collect();
        let _ = writeln!(text, "- **Arrows**{owner}: {}", labels.join(", "));
    }
    if plan.bodies.iter().any(|body| body.channels.contains(&Channel::Attitude)) {
        text +=
            "- **Body axes**, and their curves in the plots: x vermilion, y green, z blue. Grey: the world's axes\n";
        let reach = match Cut::new(plan, picture).window_s {
            Some(window) => format!("over the last {}", duration(window)),
            None => "from the beginning".to_owned(),
        };
        let _ = writeln!(text, "- **Yellow trail**: the tip of the body's spin axis, {reach}");
    }
    if picture.bodies.iter().any(|drawing| drawing.poinsot.is_some()) {
        text += "- **Poinsot**: the ellipsoid of all ω that have the body's energy rolls, without slipping, on a plane \
                 that stands still across L, here below it. They touch at ω (orange), which draws the polhode (pink) on \
                 the body and the herpolhode (yellow) on the plane\n\
                 - **L in the body**: the body sees L move on a sphere of one size (blue) and on the ellipsoid of its \
                 energy (grey), and so along their crossing (pink). A pair of closed curves about an axis: it stays near \
                 it; long curves from pole to pole: it flips\n";
    }
    let _ = writeln!(text, "- **Playback**: {} of motion in a second", duration(picture.playback_speed));
    text
}

fn row(body: &PlannedBody) -> String {
    let mass = body.properties.mass.map_or_else(|| "–".to_owned(), number);
    let moments: Vec<_> = body.properties.moments.vector().iter().map(|moment| number(*moment)).collect();
    let reason = body.reason.replace('|', "∣");
    format!("| {} | {mass} | {} | {} | {reason} |\n", body.name, moments.join(", "), body.path.name())
}

/// What the motion is held to; `polhode run` measures it.
fn checks(plan: &Plan) -> String {
    if plan.checks.is_empty() {
        return String::new();
    }
    let mut text = "\n#### What it is held to\n\n| check | expected | at most off by |\n|---|---|---|\n".to_owned();
    for check in &plan.checks {
        let (name, unit) = (check.name(&plan.bodies), check.unit);
        let _ = writeln!(text, "| {name} | {} {unit} | {} {unit} |", check.expected, number(check.tolerance));
    }
    text
}

/// What was measured of the bodies' errors, if anything.
fn certificates(plan: &Plan) -> String {
    let mut text = String::new();
    for body in &plan.bodies {
        let Some(certificate) = &body.certificate else { continue };
        let _ = writeln!(text, "\n#### Certificate: {}\n\n| | |\n|---|---|", body.name);
        for (name, value) in certificate.facts() {
            let _ = writeln!(text, "| {name} | {value} |");
        }
    }
    text
}

fn provenance(plan: &Plan) -> String {
    let mut text = String::new();
    let parts = [&plan.provenance.source, &plan.provenance.url, &plan.provenance.note];
    let said: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).map(String::as_str).collect();
    if !said.is_empty() {
        let _ = writeln!(text, "\n#### Source\n\n{}", said.join("\n\n"));
    }
    text
}

/// Five significant digits, for people.
fn number(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) {
        let digits = format!("{value:.4e}").parse::<f64>().unwrap_or(value);
        return format!("{digits}");
    }
    let digits = format!("{value:.4e}");
    let (mantissa, power) = digits.split_once('e').unwrap_or((&digits, "0"));
    format!("{}e{power}", mantissa.trim_end_matches('0').trim_end_matches('.'))
}

/// A time span in the unit that people would say it in.
fn duration(seconds: f64) -> String {
    let units = [(86400.0, "d"), (3600.0, "h"), (60.0, "min")];
    let (size, unit) = units.into_iter().find(|(size, _)| seconds >= 2.0 * size).unwrap_or((1.0, "s"));
    format!("{} {unit}", number(seconds / size))
}
