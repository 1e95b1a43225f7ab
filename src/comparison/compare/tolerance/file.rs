use std::ops::Range;
use std::path::Path;

use toml_edit::{Document, Item, Value};

use super::error::ToleranceError;
use super::rule::{Rule, Tolerance, Tolerances};
use crate::scenario::{Excerpt, Refused};
use crate::telemetry::Channel;

impl Tolerances {
    /// The same with what the TOML file at `path` says. Its keys are channels with their units:
    ///
    /// ```toml
    /// attitude_rad = 1e-9                                               # absolute
    /// angular_velocity_rad_s = { absolute = 1e-12, relative = 1e-9 }
    /// total_energy_j = { relative = 1e-12 }
    /// tilt_rad = "exact"
    /// energy_drift_per_1e15 = "shown"
    /// ```
    ///
    /// # Errors
    /// If it cannot be read, is no TOML, has an unknown key or a value that is no tolerance.
    pub fn read(self, path: &Path) -> Result<Self, ToleranceError> {
        let text = std::fs::read_to_string(path).map_err(|source| ToleranceError::Io { path: path.into(), source })?;
        self.parse(&text, &path.display().to_string())
    }

    /// The same with what TOML `text` says, which messages call `file`.
    ///
    /// # Errors
    /// If it is no TOML, has an unknown key or a value that is no tolerance.
    pub fn parse(self, text: &str, file: &str) -> Result<Self, ToleranceError> {
        let place = Place { text, file };
        let document =
            Document::parse(text).map_err(|error| place.refuse("", error.message().to_owned(), error.span()))?;
        let mut tolerances = self;
        for (name, item) in document.iter() {
            let span = document.key(name).and_then(toml_edit::Key::span);
            let Some(channel) = Channel::ALL.into_iter().find(|channel| key(*channel) == name) else {
                let message = ToleranceError::unknown(name, key).to_string();
                return Err(place.refuse("", message, span));
            };
            let rule = rule(item).map_err(|message| place.refuse(name, message, item.span()))?;
            tolerances = tolerances.with(channel, rule);
        }
        Ok(tolerances)
    }
}

/// What a channel's tolerance is called in a file: its name with the unit of its differences.
fn key(channel: Channel) -> String {
    let row = channel.row();
    let suffix = if channel == Channel::Attitude { "rad" } else { row.unit_suffix };
    format!("{}_{suffix}", row.name)
}

fn rule(item: &Item) -> Result<Rule, String> {
    const FORM: &str = "a tolerance is a number, { absolute = …, relative = … }, \"exact\" or \"shown\"";
    let tolerance = |absolute, relative| Tolerance::new(absolute, relative).map_err(|error| error.to_string());
    if let Some(word) = item.as_str() {
        return Rule::named(word).ok_or_else(|| format!("{word:?}: {FORM}"));
    }
    if let Some(absolute) = number(item) {
        return tolerance(absolute, 0.0).map(Rule::Within);
    }
    let table = item.as_table_like().filter(|table| !table.is_empty()).ok_or(FORM)?;
    let (mut absolute, mut relative) = (0.0, 0.0);
    for (name, item) in table.iter() {
        let value = match name {
            "absolute" => &mut absolute,
            "relative" => &mut relative,
            _ => return Err(format!("{name:?} is no key of a tolerance: {FORM}")),
        };
        *value = number(item).ok_or_else(|| format!("{name} is no number: {FORM}"))?;
    }
    tolerance(absolute, relative).map(Rule::Within)
}

#[expect(clippy::cast_precision_loss, reason = "a whole number for a tolerance")]
fn number(item: &Item) -> Option<f64> {
    match item.as_value()? {
        Value::Float(number) => Some(*number.value()),
        Value::Integer(number) => Some(*number.value() as f64),
        _ => None,
    }
}

/// Where messages point.
struct Place<'a> {
    text: &'a str,
    file: &'a str,
}

impl Place<'_> {
    fn refuse(&self, key: &str, message: String, span: Option<Range<usize>>) -> ToleranceError {
        let excerpt = span.map(|span| Excerpt::of(self.text, span.start, span.end));
        let (file, key) = (self.file.to_owned(), key.to_owned());
        ToleranceError::Refused(Box::new(Refused { file, key, message, excerpt }))
    }
}
