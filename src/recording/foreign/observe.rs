use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::Path;

use super::mapping::Mapping;
use super::{own, table};
use crate::recording::format::{Format, is_part};
use crate::recording::{Observed, Recording, RecordingError, mcap_file, rerun_file};

/// What a file says of bodies that turn.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Observation {
    /// Each body that moves, in the order in which the file first tells of it; at least one.
    pub bodies: Vec<Observed>,
    /// What the file's clock showed at 0 s of the bodies' times, ns: not 0 only where the file tells absolute times, which
    /// an f64 of seconds would round to 0.2 µs.
    pub start_ns: i64,
    /// Half a unit in the last place of the times as the file keeps them, s: 0 of exact ones, 5e-10 of whole ns.
    pub time_resolution_s: f64,
    /// What was left out of account, or had to be taken for granted: a sentence each.
    pub remarks: Vec<String>,
}

/// Reads what a recording, of whatever program, says of bodies that turn: `.mcap`, `.rrd`, and tables of numbers as text
/// (`.csv`, `.tsv`, `.txt`, `.dat`).
///
/// A recording of this crate tells its channels, unless the mapping names columns or a frame of its own. Values are not
/// repaired: a number that is not finite, or a time that does not come after the one before, is refused. What is read of
/// which messages, and how columns are named, is in `docs/recordings_of_others.md`.
///
/// ```
/// use polhode::recording::foreign::{Mapping, observe};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
/// let found = observe(&root.join("tests/foreign/mujoco.csv"), &Mapping::default())?;
/// let attitude = found.bodies[0].attitude.as_ref().ok_or("no columns qw, qx, qy, qz")?;
/// assert_eq!(attitude.times_s.len(), 201);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// If it cannot be read, is damaged or cut off, tells of no body, does not fit the mapping, or is of a format that this
/// build leaves out.
pub fn observe(path: &Path, mapping: &Mapping) -> Result<Observation, RecordingError> {
    let name = if is_part(path) { path.with_extension("") } else { path.into() };
    if matches!(name.extension().and_then(OsStr::to_str), Some("tsv" | "txt" | "dat")) {
        return table::observe(path, mapping);
    }
    let foreign = match Format::of(&name)? {
        Format::Csv if mapping.is_of_a_table() || !table::is_own(path)? => Some(table::observe(path, mapping)?),
        Format::Mcap => mcap_file::observe(path, mapping)?,
        Format::Rrd => rerun_file::observe(path, mapping)?,
        Format::Csv => None,
    };
    foreign.map_or_else(|| own::observe(&mut Recording::open(path)?), Ok)
}

impl Observation {
    /// Holds that no two bodies have one name.
    ///
    /// # Errors
    /// Which name is there twice.
    pub(in crate::recording) fn claim_names(&self) -> Result<(), String> {
        let mut names = BTreeSet::new();
        match self.bodies.iter().find(|body| !names.insert(&body.name)) {
            Some(body) => Err(format!("two bodies are called {:?}", body.name)),
            None => Ok(()),
        }
    }
}

impl Mapping {
    /// Whether it says anything of columns.
    fn is_of_a_table(&self) -> bool {
        !self.body.is_empty() || self.time.is_some() || self.separator.is_some() || self.header.is_some()
    }
}
