//! docs/scenarios.md has a table for every table of a scene, made of the schema.
//!
//! The text between `<!-- keys of PATH -->` (of the scene itself: `<!-- keys of a scene -->`) and `<!-- end -->` is made
//! here; what stands around it is written by hand. `POLHODE_BLESS=1 cargo test scene_schema` writes it anew.

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use polhode::telemetry::Channel;
use serde_json::Value;

use super::tables::{Key, Table};

const END: &str = "<!-- end -->";

#[test]
fn manual_has_every_key_with_unit_range_and_default() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/scenarios.md");
    let kept = fs::read_to_string(&path).expect("the manual of scenes");
    let tables = Table::all();
    let mut shown = BTreeSet::new();
    let mut parts = kept.split("<!-- keys of ");
    let mut now = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once(" -->\n").expect("the comment ends its line");
        let (_, after) = rest.split_once(END).unwrap_or_else(|| panic!("{name} has no {END}"));
        let made = block(name, &tables, &mut shown);
        let _ = write!(now, "<!-- keys of {name} -->\n\n{made}\n{END}{after}");
    }
    for table in &tables {
        // One table for all that have the same keys.
        let is_alike = |other: &&Table| other.keys == table.keys;
        let is_shown = tables.iter().filter(is_alike).any(|other| shown.contains(&other.path));
        assert!(is_shown, "docs/scenarios.md lacks `<!-- keys of {} -->` and `{END}` below it", table.path);
    }
    if std::env::var_os("POLHODE_BLESS").is_some() {
        fs::write(&path, &now).expect("the manual can be written");
    }
    let kept = fs::read_to_string(&path).expect("the manual of scenes");
    assert!(kept == now, "docs/scenarios.md is out of date: POLHODE_BLESS=1 cargo test scene_schema");
}

/// What stands under a heading comment.
fn block(name: &str, tables: &[Table], shown: &mut BTreeSet<String>) -> String {
    if name == "channels" {
        return channels();
    }
    let path = if name == "a scene" { "" } else { name };
    if let Some(names) = path.strip_prefix("names in ") {
        return choices(names, tables);
    }
    let table = tables.iter().find(|table| table.path == path).unwrap_or_else(|| panic!("no table is called {name}"));
    shown.insert(path.to_owned());
    if !table.is_of_kinds() {
        return plain(table);
    }
    let kinds: Vec<_> = table
        .keys
        .iter()
        .map(|kind| {
            let path = format!("{path}.{}", kind.name);
            let path = path.trim_start_matches('.');
            shown.insert(path.to_owned());
            (kind, tables.iter().find(|table| table.path == path).expect("a kind is a table"))
        })
        .collect();
    of_kinds(&kinds)
}

/// A row for every key.
fn plain(table: &Table) -> String {
    let mut text = "| key | type, unit | range | left out | means |\n|---|---|---|---|---|\n".to_owned();
    for key in &table.keys {
        let _ = writeln!(text, "| {} | {} |", shown_name(key, &table.path), row(key));
    }
    text
}

/// A row for every kind, those of its keys below it, and last the keys that every kind has, or every one but one.
fn of_kinds(kinds: &[(&Key, &Table)]) -> String {
    let mut text = "| kind | key | type, unit | range | left out | means |\n|---|---|---|---|---|---|\n".to_owned();
    let has = |table: &Table, key: &Key| table.keys.iter().any(|k| (&k.name, &k.schema) == (&key.name, &key.schema));
    let without = |key: &Key| kinds.iter().filter(|(_, table)| !has(table, key)).map(|(kind, _)| &kind.name).collect();
    let is_common = |key: &Key| {
        let without: Vec<_> = without(key);
        without.is_empty() || without.len() == 1 && kinds.len() > 5
    };
    for (kind, table) in kinds {
        let _ = writeln!(text, "| `{}` | | | | | {} |", kind.name, words(kind).0);
        for key in table.keys.iter().filter(|key| !is_common(key)) {
            let _ = writeln!(text, "| | `{}` | {} |", key.name, row(key));
        }
    }
    let common = kinds.first().into_iter().flat_map(|(_, table)| &table.keys).filter(|key| is_common(key));
    let mut said = None;
    for key in common {
        let whose = match without(key).as_slice() {
            [] => "every one".to_owned(),
            names => format!("every one but `{}`", names[0]),
        };
        let cell = if said.as_ref() == Some(&whose) { " ".to_owned() } else { format!(" {whose} ") };
        let _ = writeln!(text, "|{cell}| `{}` | {} |", key.name, row(key));
        said = Some(whose);
    }
    text
}

fn shown_name(key: &Key, path: &str) -> String {
    let full = if path.is_empty() { key.name.clone() } else { format!("{path}.{}", key.name) };
    match key.table() {
        Some((_, true)) => format!("`[[{full}]]`"),
        Some((inner, false)) => {
            let is_of_kinds = |schema: &Value| schema["type"] == "array";
            let inner = inner["properties"].as_object().expect("a table has keys");
            if inner.values().all(is_of_kinds) { format!("`[[{full}.…]]`") } else { format!("`[{full}]`") }
        }
        None => format!("`{}`", key.name),
    }
}

/// Type and unit, range, what it is if left out, what it means.
fn row(key: &Key) -> String {
    let (means, left_out) = words(key);
    let left_out = if key.is_needed {
        "needed".to_owned()
    } else {
        left_out.unwrap_or_else(|| if key.table().is_some() { "none".to_owned() } else { String::new() })
    };
    let unit = key.schema["x-unit"].as_str().map(|unit| format!(", {unit}")).unwrap_or_default();
    format!("{}{unit} | {} | {left_out} | {means}", kind(key), range(&key.schema)).replace("|  |", "| |")
}

fn kind(key: &Key) -> String {
    if let Some((_, is_list)) = key.table() {
        return if is_list { "tables" } else { "table" }.to_owned();
    }
    of_type(&key.schema)
}

fn of_type(schema: &Value) -> String {
    let names = names(schema);
    match (schema["type"].as_str(), schema["minItems"].as_u64(), schema["maxItems"].as_u64()) {
        _ if names.len() > 6 => "name".to_owned(),
        _ if !names.is_empty() => names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "),
        (Some("number"), ..) => "number".to_owned(),
        (Some("integer"), ..) => "whole number".to_owned(),
        (Some("string"), ..) => "text".to_owned(),
        (Some("boolean"), ..) => "true, false".to_owned(),
        (Some("array"), Some(count), Some(most)) if count == most => {
            let inner = &schema["items"];
            if inner["type"] == "array" {
                format!("{count} × {}", of_type(inner))
            } else {
                format!("{count} {}", several(inner))
            }
        }
        (Some("array"), ..) if schema["items"]["type"] == "array" => {
            format!("lists of {}", several(&schema["items"]["items"]))
        }
        (Some("array"), ..) => format!("list of {}", several(&schema["items"])),
        _ => panic!("no words for {schema:#}"),
    }
}

fn several(schema: &Value) -> String {
    of_type(schema) + "s"
}

/// The names that a text may be.
fn names(schema: &Value) -> Vec<&str> {
    let listed = schema["enum"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let described = schema["oneOf"].as_array().into_iter().flatten().filter_map(|choice| choice["const"].as_str());
    listed.chain(described).collect()
}

fn range(schema: &Value) -> String {
    let number = |key: &str| {
        schema[key].as_f64().map(|bound| match bound {
            PI => "π".to_owned(),
            whole if whole.fract() == 0.0 => whole.to_string(),
            bound => format!("{bound:?}"),
        })
    };
    let bounds = [
        number("exclusiveMinimum").map(|bound| format!("> {bound}")),
        number("minimum").map(|bound| format!("≥ {bound}")),
        number("exclusiveMaximum").map(|bound| format!("< {bound}")),
        number("maximum").map(|bound| format!("≤ {bound}")),
    ];
    let bounds: Vec<_> = bounds.into_iter().flatten().collect();
    match &schema["items"] {
        Value::Object(_) if bounds.is_empty() && schema["type"] == "array" => match range(&schema["items"]) {
            inner if inner.is_empty() || inner.starts_with("each ") => inner,
            inner => format!("each {inner}"),
        },
        _ => bounds.join(", "),
    }
}

/// What a key means, and what it is if it is left out.
fn words(key: &Key) -> (String, Option<String>) {
    let description = key.description().replace('\n', " ");
    let description = description.trim_end_matches('.').replace('|', "\\|");
    let (means, left_out) = match description.rsplit_once("; left out: ") {
        Some((means, left_out)) => (means.to_owned(), Some(left_out.to_owned())),
        None => (description, None),
    };
    // The unit has a place of its own.
    let unit = key.schema["x-unit"].as_str().map(|unit| format!(", {unit}")).unwrap_or_default();
    let plain = if unit.is_empty() { means } else { cut(&means, &unit) };
    (plain, left_out)
}

/// `text` without `unit`, where that is a word of its own.
fn cut(text: &str, unit: &str) -> String {
    let is_end = |rest: &str| rest.chars().next().is_none_or(|next| ",;:.".contains(next));
    match text.match_indices(unit).find(|(at, found)| is_end(&text[at + found.len()..])) {
        Some((at, found)) => format!("{}{}", &text[..at], &text[at + found.len()..]),
        None => text.to_owned(),
    }
}

/// The names that the key at `path` may have as its value, with what they mean.
fn choices(path: &str, tables: &[Table]) -> String {
    let (table, name) = path.rsplit_once('.').unwrap_or(("", path));
    let table = tables.iter().find(|candidate| candidate.path == table).expect("a table");
    let key = table.keys.iter().find(|key| key.name == name).expect("a key");
    let mut text = "| name | means |\n|---|---|\n".to_owned();
    for choice in key.schema["oneOf"].as_array().expect("names with words") {
        let words = choice["description"].as_str().unwrap_or_default().replace('\n', " ");
        let _ =
            writeln!(text, "| `{}` | {} |", choice["const"].as_str().unwrap_or_default(), words.trim_end_matches('.'));
    }
    text
}

fn channels() -> String {
    let mut text = "| channel | components | unit | means |\n|---|---|---|---|\n".to_owned();
    for channel in Channel::ALL {
        let row = channel.row();
        let components = if row.components.len() > 1 { row.components.join(", ") } else { "scalar".to_owned() };
        let _ = writeln!(text, "| `{}` | {components} | {} | {} |", row.name, row.unit, row.title);
    }
    text
}
