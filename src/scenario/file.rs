//! Scenes from TOML text, with overrides.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use toml_edit::{DocumentMut, Item, Value};

use super::{Excerpt, Refused, Scenario, ScenarioError, library};

/// Largest scene, in bytes of text: more than the most bodies need.
const MOST_BYTES: u64 = 16 << 20;

impl Scenario {
    /// The scene in the TOML file at `path`, after the assignments `overrides` (`key=value`).
    ///
    /// # Errors
    /// If the file cannot be read, is larger than 16 MiB, is no TOML, or holds an unknown key or a value of the wrong type.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, ScenarioError> {
        let text = read_text(path).map_err(|source| ScenarioError::Io { path: path.to_path_buf(), source })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let scenario = Self::parse(&text, &path.display().to_string(), overrides)?;
        Ok(Self { name: name.into_owned(), folder: path.parent().unwrap_or(Path::new("")).to_path_buf(), ..scenario })
    }

    /// The scene that comes with the program under `name`, after the assignments `overrides` (`key=value`).
    ///
    /// # Errors
    /// If there is none of that name, or an override is refused.
    pub fn named(name: &str, overrides: &[String]) -> Result<Self, ScenarioError> {
        let text = library::text(name)
            .ok_or_else(|| ScenarioError::UnknownScene { name: name.to_owned(), hint: library::hint(name) })?;
        Ok(Self { name: name.to_owned(), ..Self::parse(text, name, overrides)? })
    }

    /// The scene in TOML `text`, which messages call `file`.
    ///
    /// # Errors
    /// If the text is no TOML, or holds an unknown key or a value of the wrong type.
    pub fn parse(text: &str, file: &str, overrides: &[String]) -> Result<Self, ScenarioError> {
        let mut text = text.to_owned();
        let mut file = file.to_owned();
        for assignment in overrides {
            text = assign(&text, assignment).map_err(|message| refused(&file, assignment, message, None))?;
        }
        if !overrides.is_empty() {
            file.push_str(" (with --set)");
        }
        let scenario = toml::from_str::<Self>(&text).map_err(|error| {
            let excerpt = error.span().map(|span| Excerpt::of(&text, span.start, span.end));
            refused(&file, "", error.message().to_owned(), excerpt)
        })?;
        Ok(Self { text, name: file.clone(), file, ..scenario })
    }
}

/// The whole file, unless it is too large; reads no more than the limit even of a file without end.
fn read_text(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    File::open(path)?.take(MOST_BYTES + 1).read_to_string(&mut text)?;
    if text.len() as u64 > MOST_BYTES {
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, format!("it is larger than {MOST_BYTES} bytes")));
    }
    Ok(text)
}

fn refused(file: &str, key: &str, message: String, excerpt: Option<Excerpt>) -> ScenarioError {
    ScenarioError::Refused(Box::new(Refused { file: file.to_owned(), key: key.to_owned(), message, excerpt }))
}

/// `text` with `key=value` carried out; `value` is TOML, a bare word stands for a string.
fn assign(text: &str, assignment: &str) -> Result<String, String> {
    let (key, value) = assignment
        .split_once('=')
        .ok_or("an override reads key=value, such as body.0.angular_velocity_rad_s=[0, 5, 0.01]")?;
    let value = value.trim();
    let value: Value = value.parse().unwrap_or_else(|_| Value::from(value));
    let mut document: DocumentMut = text.parse().map_err(|error: toml_edit::TomlError| error.message().to_owned())?;
    let mut item = document.as_item_mut();
    for step in key.trim().split('.') {
        item = match step.parse::<usize>() {
            Ok(index) => element(item, index).ok_or_else(|| format!("there is no element {index} to set"))?,
            Err(_) => field(item, step).ok_or_else(|| format!("{step:?} is no key of a table"))?,
        };
    }
    *item = Item::Value(value);
    Ok(document.to_string())
}

fn element(item: &mut Item, index: usize) -> Option<&mut Item> {
    match item {
        Item::ArrayOfTables(tables) if index < tables.len() => item.get_mut(index),
        _ => None,
    }
}

fn field<'item>(item: &'item mut Item, name: &str) -> Option<&'item mut Item> {
    if item.is_none() {
        *item = toml_edit::table();
    }
    item.as_table_like_mut().map(|table| table.entry(name).or_insert(Item::None))
}
