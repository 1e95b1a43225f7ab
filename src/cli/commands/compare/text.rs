use std::fmt::Write as _;

use crate::cli::table::Table;
use crate::comparison::{BodyReport, ChannelReport, Comparison, Finding, Report, Rule, SideReport};
use crate::plot::grouped;

/// Columns of a line that is not a table's.
const WIDTH: usize = 80;

/// What people read: what was compared and how, each channel, what one side lacks, and the verdict last.
pub fn as_text(comparison: &Comparison, report: &Report) -> String {
    let compared: Vec<_> = report.channels().map(|(_, channel)| channel.channel).collect();
    let rules = comparison.tolerances.in_words(&compared);
    let mut text = folded(&format!("Same means: {rules}"), 2);
    text.push_str(&sides(report));
    for body in &report.bodies {
        text.push('\n');
        text.push_str(&table(body));
    }
    if !report.differences.is_empty() {
        text.push_str("\nOnly on one side:\n");
        let lines = report.differences.iter().map(|difference| report.describe(difference));
        lines.for_each(|line| text.push_str(&folded(&format!("  {line}"), 4)));
    }
    text.push_str(&events(report));
    text.push_str(&facts(report));
    text.push('\n');
    text.push_str(&folded(&report.verdict(), 2));
    text
}

fn sides(report: &Report) -> String {
    let mut table = Table::default();
    for (letter, side) in ["A", "B"].into_iter().zip(&report.sides) {
        table.row([letter.to_owned(), side.name.clone(), samples(side)]);
    }
    let common = report.common;
    // Writing to a string cannot fail.
    let mut compared =
        format!("{} times, {} to {} s", grouped(common.samples), plain(common.from_s), plain(common.to_s));
    if report.times_apart_s > 0.0 {
        let _ = write!(compared, ", up to {:.0e} s apart", report.times_apart_s);
    }
    if report.channels().any(|(_, channel)| channel.interpolation.is_some()) {
        compared.push_str(", B interpolated");
    }
    let mut text = table.render("  ");
    let _ = writeln!(text, "  compared at {compared}");
    text
}

fn samples(side: &SideReport) -> String {
    if side.is_scene {
        return "a scene, computed at these times".into();
    }
    let alone = match side.alone.samples {
        0 => String::new(),
        alone => format!(", {} of them not in the other", grouped(alone)),
    };
    let coverage = side.coverage;
    let (count, from, to) = (grouped(coverage.samples), plain(coverage.from_s), plain(coverage.to_s));
    format!("{count} samples, {from} to {to} s{alone}")
}

/// The body's channels, worst first.
fn table(body: &BodyReport) -> String {
    let [a, b] = &body.names;
    let name = if a == b || body.name() != a { body.name().to_owned() } else { format!("{a} = {b}") };
    let mut channels: Vec<&ChannelReport> = body.channels.iter().collect();
    channels.sort_by(|one, other| other.severity().total_cmp(&one.severity()));
    let mut table = Table::default();
    table.row(["", name.as_str(), "worst", "limit", "rms", "unit", "worst at s"]);
    for channel in &channels {
        table.row(row(channel));
    }
    let mut text = String::new();
    let rendered = table.render("");
    let (mut lines, mut channels) = (rendered.lines(), channels.into_iter());
    text.extend(lines.next().map(|heading| format!("{heading}\n")));
    for (line, channel) in lines.zip(&mut channels) {
        text.push_str(line);
        text.push('\n');
        if let Some(words) = since(channel) {
            text.push_str(&folded(&format!("     {words}"), 5));
        }
    }
    text
}

fn row(channel: &ChannelReport) -> [String; 7] {
    let mark = match (channel.finding(), channel.rule) {
        (Finding::Different, _) => "✗",
        (Finding::Undecided, _) => "?",
        (Finding::Same, Rule::Shown) => "·",
        (Finding::Same, _) => "✓",
    };
    let limit = match (channel.rule, channel.limit) {
        (Rule::Within(_), Some(limit)) => short(limit),
        (Rule::Shown, _) => "–".into(),
        _ => "bits".into(),
    };
    let component = |index: usize| channel.channel.row().components.get(index).copied().unwrap_or_default();
    let at = channel.worst.filter(|worst| worst.difference > 0.0).map(|worst| {
        let component = worst.component.map(|index| format!(" in {}", component(index))).unwrap_or_default();
        format!("{}{component}", plain(worst.time_s))
    });
    [
        mark.into(),
        channel.channel.row().name.into(),
        short(channel.worst_difference()),
        limit,
        short(channel.rms),
        channel.unit().into(),
        at.unwrap_or_default(),
    ]
}

/// Since when the two differ, and how that grows: of what is out of tolerance.
fn since(channel: &ChannelReport) -> Option<String> {
    if let (Finding::Undecided, Some(error)) = (channel.finding(), channel.interpolation) {
        return Some(format!("of which interpolation may make {error:.1e}"));
    }
    let first = channel.first_out_s?;
    let bits = match channel.bits.first {
        Some(mark) if channel.rule == Rule::Exact => {
            let name = channel.channel.row().components.get(mark.component).copied().unwrap_or_default();
            let name = if name.is_empty() { String::new() } else { format!("{name} ") };
            let ulps = match channel.bits.most_ulps {
                1_000_000.. => ", far apart".to_owned(),
                ulps => format!(", {} ulp at most", grouped(ulps)),
            };
            let (count, [a, b]) = (grouped(channel.bits.differing), mark.values);
            format!(": {name}{a:?} and {b:?}; {count} samples{ulps}")
        }
        _ => String::new(),
    };
    let growth = channel.growth.as_ref().map(|growth| format!("; {}", growth.in_words())).unwrap_or_default();
    let out = if channel.rule == Rule::Exact { "other bits from" } else { "out from" };
    Some(format!("{out} {} s on{bits}{growth}", plain(first)))
}

/// Events that are told at most.
const EVENTS: usize = 6;

fn events(report: &Report) -> String {
    if report.events.is_empty() {
        return String::new();
    }
    let mut table = Table::default();
    table.row(["", "A at s", "B at s"]);
    for event in report.events.iter().take(EVENTS) {
        let time = |time_s: Option<f64>| time_s.map_or("–".to_owned(), plain);
        let what: String = format!("{}: {}", event.body, event.text).chars().take(WIDTH - 34).collect();
        table.row([what, time(event.times_s[0]), time(event.times_s[1])]);
    }
    let more = match report.events.len().saturating_sub(EVENTS) {
        0 => String::new(),
        more => format!("  and {more} more\n"),
    };
    format!("\nWhat their scenes say happens at other times:\n{}{more}", table.render("  "))
}

fn facts(report: &Report) -> String {
    let [a, b] = &report.sides;
    match (a.has_provenance, b.has_provenance) {
        (true, true) if report.facts.is_empty() => return String::new(),
        (true, true) => {}
        (false, false) => return "\nNeither side says where it comes from.\n".into(),
        (is_told, _) => return format!("\n{} does not say where it comes from.\n", if is_told { "B" } else { "A" }),
    }
    let mut text = "\nThey say otherwise where they come from:\n".to_owned();
    for fact in &report.facts {
        let _ = writeln!(text, "  {}", fact.name);
        for (letter, value) in ["A", "B"].into_iter().zip(&fact.values) {
            let value = value.as_deref().map_or("–".to_owned(), |value| value.replace('\n', " "));
            text.push_str(&folded(&format!("    {letter} {value}"), 6));
        }
    }
    text
}

/// Two digits, by its power of ten where it is small or large.
fn short(value: f64) -> String {
    let rounded = format!("{value:.1e}");
    match rounded.parse::<f64>() {
        Ok(number) if number == 0.0 || (0.01..1000.0).contains(&number) => number.to_string(),
        _ => rounded,
    }
}

/// A time without the noise of its making: 0.3, not 0.30000000000000004.
fn plain(time_s: f64) -> String {
    let text = format!("{time_s:.9}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Broken at blanks where a line gets too long; lines after the first begin with `indent` blanks.
fn folded(text: &str, indent: usize) -> String {
    let start = text.len() - text.trim_start().len();
    let mut folded = " ".repeat(start);
    let mut column = start;
    for (number, word) in text.split_whitespace().enumerate() {
        let width = word.chars().count();
        if number > 0 && column + 1 + width > WIDTH {
            folded.push('\n');
            folded.push_str(&" ".repeat(indent));
            column = indent;
        } else if number > 0 {
            folded.push(' ');
            column += 1;
        }
        folded.push_str(word);
        column += width;
    }
    folded.push('\n');
    folded
}
