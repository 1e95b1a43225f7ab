use serde_json::{Value, json};

use crate::cli::growth::growth_as_json;
use crate::comparison::{
    BodyReport, ChannelReport, Comparison, Coverage, Difference, EventDifference, Finding, Mark, Report, Rule,
    SideReport, Tolerance,
};
use crate::scenario::EventKind;

/// Everything that was found, as docs/comparison.md tells it.
pub fn as_json(comparison: &Comparison, report: &Report) -> Value {
    let [a, b] = report.sides.each_ref().map(side);
    let difference = |difference: &Difference| as_difference(report, difference);
    let fact = |fact: &crate::comparison::FactDifference| json!({ "name": fact.name, "a": fact.values[0], "b": fact.values[1] });
    json!({
        "finding": finding(report.finding()),
        "same": report.is_same(),
        "same_to_the_bit": report.is_same_to_the_bit(),
        "verdict": report.verdict(),
        "exact": comparison.tolerances.are_exact(),
        "a": a,
        "b": b,
        "shift_s": comparison.shift_s,
        "common": coverage(&report.common),
        "times_apart_s": report.times_apart_s,
        "bodies": report.bodies.iter().map(body).collect::<Vec<_>>(),
        "differences": report.differences.iter().map(difference).collect::<Vec<_>>(),
        "events": report.events.iter().map(event).collect::<Vec<_>>(),
        "facts": report.facts.iter().map(fact).collect::<Vec<_>>(),
    })
}

fn event(event: &EventDifference) -> Value {
    let kind = match event.kind {
        EventKind::Flip => "flip",
        _ => "load",
    };
    json!({
        "body": event.body,
        "kind": kind,
        "number": event.number,
        "a_s": event.times_s[0],
        "b_s": event.times_s[1],
        "words": event.text,
    })
}

fn finding(finding: Finding) -> &'static str {
    match finding {
        Finding::Same => "same",
        Finding::Undecided => "undecided",
        Finding::Different => "different",
    }
}

fn side(side: &SideReport) -> Value {
    json!({
        "name": side.name,
        "is_scene": side.is_scene,
        "has_provenance": side.has_provenance,
        "coverage": coverage(&side.coverage),
        "alone": coverage(&side.alone),
    })
}

fn coverage(coverage: &Coverage) -> Value {
    let is_any = coverage.samples > 0;
    json!({
        "samples": coverage.samples,
        "from_s": is_any.then_some(coverage.from_s),
        "to_s": is_any.then_some(coverage.to_s),
    })
}

fn body(body: &BodyReport) -> Value {
    let channels: Vec<_> = body.channels.iter().map(channel).collect();
    json!({ "a": body.names[0], "b": body.names[1], "channels": channels })
}

fn channel(channel: &ChannelReport) -> Value {
    let row = channel.channel.row();
    let component = |index: usize| row.components.get(index).filter(|name| !name.is_empty());
    let (rule, tolerance) = match channel.rule {
        Rule::Exact => ("exact", None),
        Rule::Shown => ("shown", None),
        Rule::Within(tolerance) => ("within", Some(tolerance)),
    };
    let ulps = channel.bits.most_ulps;
    json!({
        "channel": row.name,
        "title": row.title,
        "unit": channel.unit(),
        "finding": finding(channel.finding()),
        "rule": rule,
        "absolute": tolerance.map(Tolerance::absolute),
        "relative": tolerance.map(Tolerance::relative),
        "limit": channel.limit,
        "interpolation": channel.interpolation,
        "samples": channel.samples,
        "size": channel.size,
        "worst": number(channel.worst_difference()),
        "worst_relative": number(channel.relative()),
        "worst_at_s": channel.worst.map(|worst| worst.time_s),
        "worst_component": channel.worst.and_then(|worst| component(worst.component?)),
        "rms": number(channel.rms),
        "first_out_s": channel.first_out_s,
        "differing_samples": channel.bits.differing,
        // NaN against a number is none that many ulps tell.
        "most_ulps": (ulps < u64::MAX).then_some(ulps),
        "first_differing": channel.bits.first.map(|Mark { time_s, component: index, values }| json!({
            "time_s": time_s,
            "component": component(index),
            "a": number(values[0]),
            "b": number(values[1]),
        })),
        "growth": channel.growth.as_ref().map(growth_as_json),
    })
}

fn as_difference(report: &Report, difference: &Difference) -> Value {
    let letter = |side: &usize| ["a", "b"][usize::from(*side > 0)];
    let (kind, side, body, channel) = match difference {
        Difference::Body { side, name } => ("body", Some(letter(side)), Some(name), None),
        Difference::Channel { side, body, channel } => {
            ("channel", Some(letter(side)), Some(body), Some(channel.row().name))
        }
        Difference::Span => ("span", None, None, None),
        Difference::Times { side } => ("times", Some(letter(side)), None, None),
    };
    let words = report.describe(difference);
    json!({ "kind": kind, "side": side, "body": body, "channel": channel, "words": words })
}

/// JSON has no word for what is not finite: it is a string, which `float` of Python and `Number` of JavaScript read.
fn number(value: f64) -> Value {
    if value.is_finite() {
        json!(value)
    } else if value.is_nan() {
        json!("NaN")
    } else {
        json!(if value > 0.0 { "Infinity" } else { "-Infinity" })
    }
}
