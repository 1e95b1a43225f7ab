use std::fmt::Write as _;

use serde_json::{Value, json};

use super::examine::Examination;
use super::finding::{Finding, Standing};
use crate::cli::args::GoldenArguments;
use crate::cli::table::Table;
use crate::comparison::{BodyReport, ChannelReport, Difference, Report};
use crate::plot::grouped;

/// A line for each golden, what changed in those that did, and what is to be done.
pub fn as_text(examination: &Examination, arguments: &GoldenArguments) -> String {
    let mut table = Table::default();
    for finding in examination.findings.iter().filter(|finding| !finding.is_same()) {
        let name = finding.golden.file_name().unwrap_or_default().to_string_lossy();
        table.row([&*name, finding.standing.name(), &size(finding)]);
    }
    let mut text = table.render("");
    for details in examination.findings.chunk_by(|one, other| one.scene == other.scene).map(details) {
        text += &details;
    }
    for path in &examination.extra {
        let _ = writeln!(text, "\n{}: no scene makes it", path.display());
    }
    if !text.is_empty() {
        text.push('\n');
    }
    text += &summary(examination, arguments);
    text
}

fn size(finding: &Finding) -> String {
    match finding.bytes_before {
        Some(before) if before != finding.bytes => format!("{} B, was {}", grouped(finding.bytes), grouped(before)),
        _ => format!("{} B", grouped(finding.bytes)),
    }
}

/// What changed in the goldens of one scene, and by how much: told once where it is the same in all formats.
fn details(findings: &[Finding]) -> String {
    let mut told: Vec<(String, Vec<String>)> = Vec::new();
    for finding in findings {
        let changes = match &finding.standing {
            Standing::Same | Standing::Missing => continue,
            Standing::Unreadable(reason) => format!("  {reason}\n"),
            Standing::Changed(report) => changes(report),
        };
        let name = finding.golden.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match told.iter_mut().find(|(known, _)| *known == changes) {
            Some((_, names)) => names.push(name),
            None => told.push((changes, vec![name])),
        }
    }
    let block = |(changes, names): &(String, Vec<String>)| format!("\n{}:\n{changes}", names.join(", "));
    told.iter().map(block).collect()
}

fn changes(report: &Report) -> String {
    let mut text = String::new();
    let mut table = Table::default();
    table.row(["body", "channel", "samples", "most ulps", "largest", "of its size", "first at", "was", "is now"]);
    let mut changed = false;
    for (body, channel) in report.channels().filter(|(_, channel)| channel.bits.differing > 0) {
        table.row(row(body, channel));
        changed = true;
    }
    if changed {
        text += &table.render("  ");
    } else {
        text += "  every value is the same\n";
    }
    for difference in &report.differences {
        let _ = writeln!(text, "  {}", in_words(difference, report));
    }
    for fact in &report.facts {
        let [was, is] = fact.values.each_ref().map(|value| value.as_deref().unwrap_or("nothing"));
        let _ = writeln!(text, "  {} says {is}, said {was}", fact.name);
    }
    text
}

fn row(body: &BodyReport, channel: &ChannelReport) -> [String; 9] {
    let (first, was, is) = channel.bits.first.map_or_else(Default::default, |first| {
        let name = channel.channel.row().components.get(first.component).copied().unwrap_or("");
        let value = |value: f64| if name.is_empty() { format!("{value:?}") } else { format!("{name} = {value:?}") };
        (format!("{} s", first.time_s), value(first.values[0]), format!("{:?}", first.values[1]))
    });
    let ulps = match channel.bits.most_ulps {
        u64::MAX => "no number".into(),
        ulps if ulps > 1_000_000 => format!("{ulps:.1e}"),
        ulps => grouped(ulps),
    };
    [
        body.names[0].clone(),
        channel.channel.row().name.to_owned(),
        format!("{} of {}", channel.bits.differing, channel.samples),
        ulps,
        format!("{:.1e}", channel.worst_difference()),
        format!("{:.1e}", channel.relative()),
        first,
        was,
        is,
    ]
}

fn in_words(difference: &Difference, report: &Report) -> String {
    let who = |side: usize| if side == 0 { "only the golden has" } else { "only the scene has now" };
    match difference {
        Difference::Body { side, name } => format!("{} the body {name}", who(*side)),
        Difference::Channel { side, body, channel } => format!("{} {} of {body}", who(*side), channel.row().name),
        Difference::Span => {
            let [was, is] = report.sides.each_ref().map(|side| side.coverage);
            format!("from {} to {} s, was from {} to {} s", is.from_s, is.to_s, was.from_s, was.to_s)
        }
        Difference::Times { side } => {
            format!("{} {} sample times", who(*side), report.sides[*side].alone.samples)
        }
    }
}

/// What it comes to, and what is to be done.
fn summary(examination: &Examination, arguments: &GoldenArguments) -> String {
    let count = examination.findings.len();
    let changed = examination.findings.iter().filter(|finding| !finding.is_same()).count();
    let mut text = match (changed, arguments.bless) {
        (0, _) => format!("{count} goldens, {} kB: the same in every byte\n", kilobytes(examination)),
        (_, true) => format!("{changed} of {count} goldens written\n"),
        (_, false) => format!("{changed} of {count} goldens are others; where that is meant: {}\n", bless(arguments)),
    };
    for path in &examination.extra {
        let _ = writeln!(text, "to be removed, or its scene to be put back: {}", path.display());
    }
    if let Some(values) = &examination.values {
        let _ = writeln!(text, "golden values: sha256:{values}");
    }
    if arguments.bless && has_other_values(examination) {
        text += "values changed: the changelog is to name what changed and why";
        text += if examination.values.is_some() { ", and the line above\n" } else { "\n" };
    }
    text
}

/// Whether blessing has changed a value. A golden that could not be read may have had the same.
fn has_other_values(examination: &Examination) -> bool {
    match (&examination.values_before, &examination.values) {
        (Some(before), Some(now)) => before != now,
        _ => examination.findings.iter().any(|finding| finding.standing.has_other_values()),
    }
}

/// The size of all.
fn kilobytes(examination: &Examination) -> String {
    grouped(examination.findings.iter().map(|finding| finding.bytes).sum::<u64>().div_ceil(1000))
}

/// The command that writes what is asked for.
fn bless(arguments: &GoldenArguments) -> String {
    let mut command = "polhode golden --bless".to_owned();
    if arguments.folder.as_os_str() != "recordings/golden" {
        let _ = write!(command, " --folder {}", arguments.folder.display());
    }
    if let Some(folder) = &arguments.scenes_in {
        let _ = write!(command, " --scenes-in {}", folder.display());
    }
    for scene in &arguments.scenes {
        let _ = write!(command, " {scene}");
    }
    command
}

/// The same for programs.
pub fn as_json(examination: &Examination, arguments: &GoldenArguments) -> Value {
    let paths: Vec<_> = examination.extra.iter().map(|path| path.display().to_string()).collect();
    json!({
        "folder": arguments.folder.display().to_string(),
        "is_same": examination.is_same(),
        "blessed": arguments.bless,
        "values_sha256": examination.values,
        "extra": paths,
        "goldens": examination.findings.iter().map(finding_as_json).collect::<Vec<_>>(),
    })
}

fn finding_as_json(finding: &Finding) -> Value {
    let (changes, reason) = match &finding.standing {
        Standing::Changed(report) => (changes_as_json(report), None),
        Standing::Unreadable(reason) => (Vec::new(), Some(reason)),
        Standing::Same | Standing::Missing => (Vec::new(), None),
    };
    json!({
        "scene": finding.scene,
        "file": finding.golden.display().to_string(),
        "standing": finding.standing.name(),
        "bytes_before": finding.bytes_before,
        "bytes": finding.bytes,
        "changes": changes,
        "reason": reason,
    })
}

fn changes_as_json(report: &Report) -> Vec<Value> {
    let change = |(body, channel): (&BodyReport, &ChannelReport)| {
        json!({
            "body": body.names[0],
            "channel": channel.channel.row().name,
            "samples": channel.bits.differing,
            "most_ulps": channel.bits.most_ulps,
            "largest": channel.worst_difference(),
            "relative": channel.relative(),
            "first_s": channel.bits.first.map(|first| first.time_s),
        })
    };
    report.channels().filter(|(_, channel)| channel.bits.differing > 0).map(change).collect()
}
