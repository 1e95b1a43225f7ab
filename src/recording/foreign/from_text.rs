use std::path::Path;

use serde::Deserialize as _;
use toml::{Table, Value};

use super::mapping::Mapping;
use crate::recording::RecordingError;

impl Mapping {
    /// Reads a mapping from TOML.
    ///
    /// # Errors
    /// If it cannot be read or is no mapping: with line and place.
    pub fn read(path: &Path) -> Result<Self, RecordingError> {
        let io_error = |source| RecordingError::Io { attempt: "read", path: path.into(), source };
        let text = std::fs::read_to_string(path).map_err(io_error)?;
        let refused = |error: toml::de::Error| RecordingError::Decode { path: path.into(), reason: error.to_string() };
        toml::from_str(&text).map_err(refused)
    }

    /// Reads a mapping from a line, with the keys of one body beside those of the file, between commas, with blanks between
    /// several columns: `time=t, quaternion=qw qx qy qz, angular_velocity=wx wy wz, angular_velocity_axes=body`.
    ///
    /// # Errors
    /// Which key or value is none.
    pub fn of_columns(text: &str) -> Result<Self, String> {
        const OF_THE_FILE: [&str; 7] = ["separator", "header", "time", "time_unit", "frame", "world", "timeline"];
        let (mut file, mut body) = (Table::new(), Table::new());
        for assignment in text.split(',').map(str::trim).filter(|assignment| !assignment.is_empty()) {
            let (key, value) =
                assignment.split_once('=').ok_or_else(|| format!("{assignment:?} is no assignment: key=columns"))?;
            let (key, words) = (key.trim(), value.split_whitespace().collect::<Vec<_>>());
            let value = match words.as_slice() {
                [] => return Err(format!("{key} has no value")),
                ["true"] if key == "header" => Value::Boolean(true),
                ["false"] if key == "header" => Value::Boolean(false),
                [single] => Value::from(*single),
                several => Value::from(several.to_vec()),
            };
            let table = if OF_THE_FILE.contains(&key) { &mut file } else { &mut body };
            if table.insert(key.into(), value).is_some() {
                return Err(format!("{key} is there twice"));
            }
        }
        if !body.is_empty() {
            file.insert("body".into(), Value::Array(vec![Value::Table(body)]));
        }
        Self::deserialize(file).map_err(|error| error.message().to_owned())
    }
}
