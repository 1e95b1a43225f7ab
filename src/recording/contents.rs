use std::path::Path;

use super::format::{Format, is_part};
use super::{RecordingError, csv_file, mcap_file, rerun_file};

/// What is in a recording, for people: which parts, how many of each, over which time.
#[derive(Debug, Clone, PartialEq)]
pub struct Contents {
    /// `mcap`, `rrd` or `csv`.
    pub format: &'static str,
    /// Facts about the whole, as name and value.
    pub details: Vec<(String, String)>,
    /// Topics, entities or columns.
    pub entries: Vec<Entry>,
}

/// One topic, entity or column.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// As the recording calls it.
    pub name: String,
    /// Its schema or component.
    pub kind: String,
    /// How many values it has.
    pub count: u64,
    /// Time of the first, s.
    pub from_s: Option<f64>,
    /// Time of the last, s.
    pub to_s: Option<f64>,
}

/// Looks into a recording, the format by extension. `NAME.mcap.part` and the like are looked into as far as they go;
/// under its final name a recording must be whole.
///
/// # Errors
/// If it cannot be read, is damaged or incomplete, or of a format that this build leaves out.
pub fn contents(path: &Path) -> Result<Contents, RecordingError> {
    let name = if is_part(path) { path.with_extension("") } else { path.into() };
    match Format::of(&name)? {
        Format::Mcap => mcap_file::contents(path),
        Format::Rrd => rerun_file::contents(path),
        Format::Csv => csv_file::contents(path),
    }
}
