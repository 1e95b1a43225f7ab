use std::fmt::Write as _;

use re_sdk_types::archetypes::{TextDocument, TextLog};
use re_sdk_types::components::TextLogLevel;

use super::trail::Cut;
use crate::recording::picture::{Picture, Quantity, scale};
use crate::scenario::{Certificate, CheckOutcome, Event, EventKind, Plan, PlannedBody};
use crate::telemetry::{Channel, PointKind};

/// The scene in words: what it is, what to see, what was done, where it comes from.
pub(super) fn document(plan: &Plan, picture: &Picture) -> TextDocument {
    let mut text = format!("### {}\n\n{}\n\n", plan.title, plan.summary);
    text += &exactness(plan);
    text += "\n#### What you see\n\n";
    text += &legend(plan, picture);
    text += &checks(plan);
    text += "\n#### Bodies\n\n";
    text += "| body | mass (kg) | principal moments (kg m²) | method | because |\n|---|---|---|---|---|\n";
    for body in &plan.bodies {
        text += &row(body);
    }
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
    let level = |event: &Event| if event.kind == EventKind::Failed { TextLogLevel::WARN } else { TextLogLevel::INFO };
    let levels = plan.events.iter().map(|event| TextLogLevel::from(level(event)));
    TextLog::update_fields().with_many_text(texts).with_many_level(levels)
}

/// How far the motion is to be believed: a line for the error, one for the checks.
fn exactness(plan: &Plan) -> String {
    let mut text = String::new();
    let certified: Vec<_> = plan.bodies.iter().filter_map(|body| body.certificate.as_ref()).collect();
    let error = |certificate: &Certificate| certificate.attitude_rad.unwrap_or(certificate.angular_velocity_relative);
    let worst = certified.iter().max_by(|a, b| error(a).total_cmp(&error(b)));
    if let Some(worst) = worst.filter(|_| certified.len() == plan.bodies.len()) {
        let owner = if certified.len() > 1 { "of the worst body " } else { "" };
        let _ = writeln!(text, "- **Exact**: {owner}{}", measured(worst));
    }
    let passed = plan.outcomes.iter().filter(|outcome| outcome.passed).count();
    match plan.outcomes.len() {
        0 => {}
        1 if passed == 1 => {
            text += "- **Checked**: the one check, against a number found apart from this program, is met\n";
        }
        all if passed == all => {
            let _ = writeln!(
                text,
                "- **Checked**: all {all} checks, against laws and numbers found apart from this program, are met"
            );
        }
        all => {
            let _ = writeln!(text, "- **Checked**: **{} of {all} checks FAILED**", all - passed);
        }
    }
    text
}

/// The error in numbers, and as something that can be imagined.
fn measured(certificate: &Certificate) -> String {
    /// m.
    const HAIR: f64 = 1e-4;
    let end = if certificate.is_whole { "the last".to_owned() } else { duration(certificate.covered_to_s) };
    let reach = format!("at any of {} samples from the first to {end}", certificate.samples);
    let by = "measured against the same motion computed with twice as many digits";
    match certificate.attitude_rad {
        Some(error) if error > 0.0 => {
            let far = kilometres(HAIR / error);
            format!(
                "the attitude is at most {} rad off {reach}, the angle of a hair's breadth seen from {far}; {by}",
                no_less(error)
            )
        }
        Some(_) => format!("the attitude is off by nothing that could be measured {reach}; {by}"),
        None => {
            let error = certificate.angular_velocity_relative;
            format!("the angular velocity is at most {} of its size off {reach}; {by}", no_less(error))
        }
    }
}

/// One digit, rounded up.
fn no_less(error: f64) -> String {
    let nearest = format!("{error:.0e}");
    let (_, power) = nearest.split_once('e').unwrap_or((&nearest, "0"));
    let number = |text: &str| text.parse::<f64>().unwrap_or(error);
    if number(&nearest) >= error { nearest } else { format!("{:.0e}", error + 0.5 * number(&format!("1e{power}"))) }
}

/// A round distance, as people say it.
fn kilometres(metres: f64) -> String {
    let round = scale::round_down(metres / 1e3);
    if round < 1e6 { format!("{} km", number(round)) } else { format!("{} million km", number(round / 1e6)) }
}

/// What the colours and lengths mean.
fn legend(plan: &Plan, picture: &Picture) -> String {
    let mut text = String::new();
    let mut arrows: Vec<_> = picture.bodies.iter().flat_map(|drawing| &drawing.arrows).collect();
    arrows.sort_by_key(|arrow| arrow.quantity);
    arrows.dedup_by_key(|arrow| arrow.quantity);
    let names: Vec<_> = arrows.iter().map(|arrow| format!("{} {}", colour_of(arrow.quantity), arrow.label)).collect();
    if !names.is_empty() {
        let _ = writeln!(text, "- **Arrows**: {}", names.join(", "));
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
    if picture.bodies.iter().any(|drawing| !drawing.cords.is_empty()) {
        text += "- **Straw-coloured lines**: springs and cords, also while they are slack\n";
    }
    if plan.bodies.iter().flat_map(|body| &body.points).any(|point| matches!(point.kind, PointKind::Mounted(_))) {
        text += "- **Points** with names: probes and IMUs where they sit, and in their colours the ways of probes\n";
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

/// The arrow's colour, and what its symbol means.
const fn colour_of(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::AngularVelocity => "orange the angular velocity",
        Quantity::AngularMomentum => "blue the angular momentum",
        Quantity::Moment => "pink the torque",
        Quantity::Force => "green the force",
    }
}

fn row(body: &PlannedBody) -> String {
    let mass = body.properties.mass.map_or_else(|| "–".to_owned(), number);
    let moments: Vec<_> = body.properties.moments.vector().iter().map(|moment| number(*moment)).collect();
    let reason = body.reason.replace('|', "∣");
    format!("| {} | {mass} | {} | {} | {reason} |\n", body.name, moments.join(", "), body.path.name())
}

/// What the motion is held to, and what was found if someone has measured.
fn checks(plan: &Plan) -> String {
    if !plan.outcomes.is_empty() {
        return findings(&plan.outcomes);
    }
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

fn findings(outcomes: &[CheckOutcome]) -> String {
    let head = "| check | measured | expected | at most off by | |\n|---|---|---|---|---|\n";
    let mut text = format!("\n#### What it was held to\n\n{head}");
    for outcome in outcomes {
        let CheckOutcome { name, expected, measured, tolerance, unit, passed, .. } = outcome;
        let verdict = if *passed { "met" } else { "**FAILED**" };
        // Of a value that must be zero, no digit but the first few means anything.
        let shown = |value: f64| if *expected == 0.0 { number(value) } else { value.to_string() };
        let (measured, expected) = (shown(*measured), shown(*expected));
        let _ = writeln!(
            text,
            "| {name} | {measured} {unit} | {expected} {unit} | {} {unit} | {verdict} |",
            number(*tolerance)
        );
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_not_said_smaller_than_it_is() {
        let said = [(5.0e-16, "5e-16"), (5.1e-16, "6e-16"), (5.9e-16, "6e-16"), (9.2e-16, "1e-15"), (1.04, "2e0")];
        for (error, text) in said {
            assert_eq!(no_less(error), text);
        }
    }
}
