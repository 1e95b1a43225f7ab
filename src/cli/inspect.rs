use std::io;

use serde_json::json;

use super::args::InspectArguments;
use super::execute::Outcome;
use super::output::{print, print_json, remark};
use super::table::{Table, grouped};
use crate::recording::{Contents, contents};

/// Shows what is in a recording.
pub fn execute(arguments: &InspectArguments) -> io::Result<Outcome> {
    match contents(&arguments.file) {
        Ok(contents) if arguments.json => print_json(&as_json(&contents))?,
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
    text
}

fn as_json(contents: &Contents) -> serde_json::Value {
    let details: Vec<_> =
        contents.details.iter().map(|(name, value)| json!({ "name": name, "value": value })).collect();
    let entry = |entry: &crate::recording::Entry| {
        json!({
            "name": entry.name,
            "kind": entry.kind,
            "count": entry.count,
            "from_s": entry.from_s,
            "to_s": entry.to_s,
        })
    };
    let entries: Vec<_> = contents.entries.iter().map(entry).collect();
    json!({ "format": contents.format, "details": details, "entries": entries })
}
