use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::assign::assign;
use super::parse::{Fault, scene};
use crate::scenario::faults::Faults;
use crate::scenario::{Excerpt, Refused, Scenario, ScenarioError, library};

/// Largest scene, in bytes of text: more than the most bodies need.
const MOST_BYTES: u64 = 16 << 20;

impl Scenario {
    /// The scene in the TOML file at `path`, after the assignments `overrides` (`key=value`).
    ///
    /// # Errors
    /// If the file cannot be read, is larger than 16 MiB, is no TOML, or holds an unknown key or a value of the wrong type.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, ScenarioError> {
        Self::from_file(path, overrides).map_err(|faults| faults.first)
    }

    /// As [`Self::read`], and where that fails every fault that can be told apart, in the order in which they are met.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_all(path: &Path, overrides: &[String]) -> Result<Self, Vec<ScenarioError>> {
        Self::from_file(path, overrides).map_err(Faults::all)
    }

    fn from_file(path: &Path, overrides: &[String]) -> Result<Self, Faults<ScenarioError>> {
        let text = read_text(path).map_err(|source| ScenarioError::Io { path: path.to_path_buf(), source })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let scenario = Self::from_text(&text, &path.display().to_string(), overrides)?;
        Ok(Self { name: name.into_owned(), folder: path.parent().unwrap_or(Path::new("")).to_path_buf(), ..scenario })
    }

    /// The scene that comes with the program under `name`, after the assignments `overrides` (`key=value`).
    ///
    /// # Errors
    /// If there is none of that name, or an override is refused.
    pub fn named(name: &str, overrides: &[String]) -> Result<Self, ScenarioError> {
        Self::from_library(name, overrides).map_err(|faults| faults.first)
    }

    /// As [`Self::named`], and where that fails every fault that can be told apart.
    ///
    /// # Errors
    /// As [`Self::named`].
    pub fn named_all(name: &str, overrides: &[String]) -> Result<Self, Vec<ScenarioError>> {
        Self::from_library(name, overrides).map_err(Faults::all)
    }

    fn from_library(name: &str, overrides: &[String]) -> Result<Self, Faults<ScenarioError>> {
        let text = library::text(name)
            .ok_or_else(|| ScenarioError::UnknownScene { name: name.to_owned(), hint: library::hint(name) })?;
        Ok(Self { name: name.to_owned(), ..Self::from_text(text, name, overrides)? })
    }

    /// The scene in TOML `text`, which messages call `file`.
    ///
    /// # Errors
    /// If the text is no TOML, or holds an unknown key or a value of the wrong type.
    pub fn parse(text: &str, file: &str, overrides: &[String]) -> Result<Self, ScenarioError> {
        Self::from_text(text, file, overrides).map_err(|faults| faults.first)
    }

    fn from_text(text: &str, file: &str, overrides: &[String]) -> Result<Self, Faults<ScenarioError>> {
        let mut text = text.to_owned();
        let mut file = file.to_owned();
        for assignment in overrides {
            text = assign(&text, assignment).map_err(|message| refused(&file, assignment.clone(), message, None))?;
        }
        if !overrides.is_empty() {
            file.push_str(" (with --set)");
        }
        match scene(&text) {
            Ok(scenario) => Ok(Self { text, name: file.clone(), file, ..scenario }),
            Err(faults) => Err(faults.map(|Fault { key, message, span }| {
                refused(&file, key, message, span.map(|span| Excerpt::of(&text, span.start, span.end)))
            })),
        }
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

fn refused(file: &str, key: String, message: String, excerpt: Option<Excerpt>) -> ScenarioError {
    ScenarioError::Refused(Box::new(Refused { file: file.to_owned(), key, message, excerpt }))
}
