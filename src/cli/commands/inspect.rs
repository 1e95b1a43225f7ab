use std::io;

use serde_json::{Map, Value, json};

use crate::cli::args::InspectArguments;
use crate::cli::execute::Outcome;
use crate::cli::output::{print, print_json, remark};
use crate::cli::table::Table;
use crate::plot::grouped;
use crate::recording::{Contents, Entry, Range, Survey, contents};

/// Shows what is in a recording.
pub fn execute(arguments: &InspectArguments) -> io::Result<Outcome> {
    match contents(&arguments.file) {
        Ok(contents) if arguments.json => print_json(&as_json(&arguments.file.display().to_string(), &contents))?,
        Ok(contents) => print(&as_text(&arguments.file.display().to_string(), &contents))?,
        Err(error) => {
            remark(&format!("error: {error}"));
            return Ok(Outcome::Impossible);
        }
    }
    Ok(Outcome::Done)
}

fn as_text(file: &str, contents: &Contents) -> String {
    let mut text = format!("{file}: {}\n", contents.format);
    let mut details = Table::default();
    for (name, value) in &contents.details {
        for (index, line) in value.lines().enumerate() {
            details.row([if index == 0 { name.as_str() } else { "" }, line]);
        }
    }
    text.push_str(&details.render("  "));
    if contents.entries.is_empty() {
        return text;
    }
    let mut entries = Table::default();
    entries.row(["name", "kind", "count", "from s", "to s"]);
    for entry in &contents.entries {
        let time = |time: Option<f64>| time.map_or_else(|| "–".to_owned(), |time| time.to_string());
        entries.row([
            entry.name.clone(),
            entry.kind.clone(),
            grouped(entry.count),
            time(entry.from_s),
            time(entry.to_s),
        ]);
    }
    text.push('\n');
    text.push_str(&entries.render("  "));
    if let Some(survey) = &contents.survey {
        text.push('\n');
        text.push_str(&ranges(survey));
    }
    text
}

/// Between which values each column is.
fn ranges(survey: &Survey) -> String {
    let mut table = Table::default();
    table.row(["body", "column", "unit", "least", "greatest"]);
    for range in &survey.ranges {
        let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| format!("{value:?}"));
        let body = survey.heading.bodies.get(range.body).map_or("", |body| &body.name);
        let row = range.channel.row();
        table.row([body, &range.name(), row.unit, &number(range.least), &number(range.greatest)]);
    }
    table.render("  ")
}

fn as_json(file: &str, contents: &Contents) -> Value {
    let details: Vec<_> =
        contents.details.iter().map(|(name, value)| json!({ "name": name, "value": value })).collect();
    let entry = |entry: &Entry| {
        json!({
            "name": entry.name,
            "kind": entry.kind,
            "count": entry.count,
            "from_s": entry.from_s,
            "to_s": entry.to_s,
        })
    };
    let entries: Vec<_> = contents.entries.iter().map(entry).collect();
    let survey = contents.survey.as_ref().map(survey_as_json);
    json!({
        "file": file,
        "format": contents.format,
        "is_whole": contents.is_whole,
        "details": details,
        "entries": entries,
        "recording": survey,
    })
}

fn survey_as_json(survey: &Survey) -> Value {
    let facts = |facts: &[(String, String)]| -> Value {
        facts.iter().map(|(name, value)| (name.clone(), Value::from(value.as_str()))).collect::<Map<_, _>>().into()
    };
    let column = |range: &Range| {
        let row = range.channel.row();
        json!({
            "name": range.name(),
            "channel": row.name,
            "title": row.title,
            "unit": row.unit,
            "least": range.least,
            "greatest": range.greatest,
        })
    };
    let bodies = survey.heading.bodies.iter().enumerate().map(|(number, body)| {
        let columns: Vec<_> = survey.ranges.iter().filter(|range| range.body == number).map(column).collect();
        json!({ "name": body.name, "certificate": facts(&body.certificate), "columns": columns })
    });
    json!({
        "samples": survey.samples,
        "from_s": survey.from_s,
        "to_s": survey.to_s,
        "interval_s": survey.interval_s,
        "scene": survey.heading.scene,
        "provenance": facts(&survey.heading.provenance),
        "bodies": bodies.collect::<Vec<_>>(),
    })
}
