use std::borrow::Cow;

use super::fields::fields;
use crate::recording::RecordingError;
use crate::recording::csv_file::Lines;
use crate::recording::foreign::{Mapping, Separator};

/// How a table is laid out.
#[derive(Debug)]
pub(super) struct Head {
    pub separator: Separator,
    /// What the columns are called; empty if they are not.
    pub names: Vec<String>,
    /// How many there are.
    pub columns: usize,
    /// Whether the line in hand is the first of numbers.
    pub is_at_numbers: bool,
}

/// Whether a line holds no columns: it is empty, or a remark.
pub(super) fn is_remark(line: &str) -> bool {
    let line = line.trim_start();
    line.is_empty() || line.starts_with(['#', '%']) || line.starts_with("//")
}

/// Reads up to the first line of columns, which names them or holds numbers; the last remark before numbers may name
/// them, too, as numpy writes it.
///
/// # Errors
/// If it cannot be read, or there is no such line.
pub(super) fn read(lines: &mut Lines, mapping: &Mapping) -> Result<Head, RecordingError> {
    let mut remark = String::new();
    loop {
        if !lines.advance()? {
            return Err(lines.refuse("it has no line of columns".into()));
        }
        let line = lines.text();
        let text = line.strip_prefix('\u{feff}').unwrap_or(line);
        if !is_remark(text) {
            break;
        }
        text.trim_start().trim_start_matches(['#', '%', '/']).clone_into(&mut remark);
    }
    let line = lines.text().strip_prefix('\u{feff}').unwrap_or(lines.text());
    let separator = mapping.separator.unwrap_or_else(|| Separator::of(line));
    let found = fields(line, separator).map_err(|reason| lines.wrong(reason))?;
    let columns = found.len();
    let names_columns = mapping.header.unwrap_or_else(|| found.iter().any(|field| field.parse::<f64>().is_err()));
    if names_columns {
        let names = found.into_iter().map(Cow::into_owned).collect();
        return Ok(Head { separator, names, columns, is_at_numbers: false });
    }
    let names = fields(&remark, separator).unwrap_or_default();
    let names = if names.len() == columns { names.into_iter().map(Cow::into_owned).collect() } else { Vec::new() };
    Ok(Head { separator, names, columns, is_at_numbers: true })
}
