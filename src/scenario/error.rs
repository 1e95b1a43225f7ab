use std::fmt;
use std::path::PathBuf;

use thiserror::Error;

use crate::propagation::PropagationError;

/// A scene that cannot be read, planned or run.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ScenarioError {
    /// The file cannot be read.
    #[error("cannot read the scene {path}: {source}", path = path.display())]
    Io {
        /// Which file.
        path: PathBuf,
        /// Why not.
        source: std::io::Error,
    },
    /// No scene of that name comes with the program, and no file of that name is there.
    #[error("no scene is called {name:?}{hint}")]
    UnknownScene {
        /// As asked for.
        name: String,
        /// `; did you mean …?`, or what to do.
        hint: String,
    },
    /// A key or a value that the rules refuse.
    #[error("{0}")]
    Refused(Box<Refused>),
    /// The motion cannot be propagated.
    #[error(transparent)]
    Propagation(#[from] PropagationError),
}

/// Where a scene breaks which rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// Name of the file or scene.
    pub file: String,
    /// Path of the key, such as `body[0].attitude`; empty where the text is no TOML.
    pub key: String,
    /// The value met and the rule.
    pub message: String,
    /// Line and column, from 1, and the line with a caret under what is wrong; where the text is at hand.
    pub excerpt: Option<Excerpt>,
}

/// A line of a scene with something wrong in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt {
    /// From 1.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
    /// How many characters are wrong, at least 1.
    pub width: usize,
    /// The line's text.
    pub text: String,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, key, message, excerpt } = self;
        let colon = if key.is_empty() { "" } else { ": " };
        let Some(Excerpt { line, column, width, text }) = excerpt else {
            return write!(f, "{file}: {key}{colon}{message}");
        };
        let margin = " ".repeat(line.to_string().len());
        let indent = " ".repeat(column - 1);
        let carets = "^".repeat(*width);
        write!(
            f,
            "{file}:{line}:{column}: {key}{colon}{message}\n{margin} |\n{line} | {text}\n{margin} | {indent}{carets}"
        )
    }
}

impl Excerpt {
    /// The line of `text` that holds the bytes `start..end`, marked to the line's end at most.
    #[must_use]
    pub fn of(text: &str, start: usize, end: usize) -> Self {
        let start = (0..=start.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let end = (start..=end.clamp(start, line_end)).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(start);
        Self {
            line: text[..line_start].matches('\n').count() + 1,
            column: text[line_start..start].chars().count() + 1,
            width: text[start..end].trim_end().chars().count().max(1),
            text: text[line_start..line_end].trim_end().to_owned(),
        }
    }
}
