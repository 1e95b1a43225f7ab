use std::path::Path;

use super::format::{Format, is_part};
use super::{Interruption, Range, Recording, RecordingError, Survey, mcap_file, rerun_file};

/// What is in a recording, for people: which parts, how many of each, over which time.
#[derive(Debug, Clone, PartialEq)]
pub struct Contents {
    /// `mcap`, `rrd` or `csv`.
    pub format: &'static str,
    /// Whether its end is there, and all samples that it says were planned.
    pub is_whole: bool,
    /// Facts about the whole, as name and value.
    pub details: Vec<(String, String)>,
    /// Topics, entities or columns.
    pub entries: Vec<Entry>,
    /// Its columns, read from end to end, if this crate wrote it.
    pub survey: Option<Survey>,
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
/// under its final name a recording must be whole. Of other programs' recordings the parts are told, not the columns.
///
/// # Errors
/// If it cannot be read, is damaged or incomplete, or of a format that this build leaves out.
pub fn contents(path: &Path) -> Result<Contents, RecordingError> {
    let name = if is_part(path) { path.with_extension("") } else { path.into() };
    let mut contents = match Format::of(&name)? {
        Format::Mcap => mcap_file::contents(path)?,
        Format::Rrd => rerun_file::contents(path)?,
        Format::Csv => return Survey::of(&mut Recording::open(path)?).map(of_columns),
    };
    if contents.entries.iter().any(Entry::holds_columns) {
        let survey = Survey::of(&mut Recording::open(path)?)?;
        contents.add_facts(&survey);
        contents.add_interruption(&survey);
        contents.survey = Some(survey);
    }
    Ok(contents)
}

impl Contents {
    /// Says where the recording comes from and how true it is, where the format's own facts do not.
    fn add_facts(&mut self, survey: &Survey) {
        for (name, value) in &survey.heading.provenance {
            if !self.details.iter().any(|(known, _)| known == name) {
                self.details.push((name.clone(), value.clone()));
            }
        }
    }
}

impl Contents {
    /// Says of a recording that ends as a whole one does, and holds fewer samples than planned, that it is not.
    fn add_interruption(&mut self, survey: &Survey) {
        if !self.is_whole || survey.is_whole {
            return;
        }
        self.is_whole = false;
        let planned = survey.heading.planned_samples();
        let end = Interruption { samples: survey.samples, planned, to_s: survey.sampling().to_s };
        for (_, value) in self.details.iter_mut().filter(|(name, _)| name == "state") {
            *value = format!("interrupted: {}", end.in_words());
        }
    }
}

impl Entry {
    /// Whether this is what this crate calls the columns of a body.
    fn holds_columns(&self) -> bool {
        self.kind == "polhode.BodyState" || self.name.starts_with("/body/") && self.name.contains("/plots/")
    }
}

/// A `.csv` is nothing but its columns.
fn of_columns(survey: Survey) -> Contents {
    let bodies = &survey.heading.bodies;
    let name = |range: &Range| match bodies.get(range.body) {
        Some(body) if bodies.len() > 1 => format!("{}.{}", body.name, range.name()),
        _ => range.name(),
    };
    let names = std::iter::once("time_s".to_owned()).chain(survey.ranges.iter().map(name));
    let is_whole = survey.is_whole;
    let (count, from_s, to_s) = (survey.samples, survey.from_s, survey.to_s);
    let entries: Vec<_> = names.map(|name| Entry { name, kind: "column".into(), count, from_s, to_s }).collect();
    let details = vec![("rows".into(), count.to_string()), ("columns".into(), entries.len().to_string())];
    Contents { format: "csv", is_whole, details, entries, survey: Some(survey) }
}
