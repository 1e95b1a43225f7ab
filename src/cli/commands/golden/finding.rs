use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::error::GoldenError;
use crate::comparison::{Comparison, Report, Side, Tolerances};
use crate::recording::PartFile;

/// How one golden stands to what its scene gives now.
#[derive(Debug)]
pub struct Finding {
    /// Name of the scene.
    pub scene: String,
    /// Where the golden is, or is to be.
    pub golden: PathBuf,
    /// Its size before, if it was there.
    pub bytes_before: Option<u64>,
    /// The size of what the scene gives now.
    pub bytes: u64,
    /// In what it differs.
    pub standing: Standing,
}

/// In what a golden differs from what its scene gives now.
#[derive(Debug)]
pub enum Standing {
    /// In no byte.
    Same,
    /// It is not there.
    Missing,
    /// In bytes; how the values differ is in the report, if they do.
    Changed(Box<Report>),
    /// It is no recording any more, for this reason.
    Unreadable(String),
}

impl Finding {
    /// Holds the golden at `golden` to `fresh`, what its scene gives now.
    pub fn new(scene: &str, golden: PathBuf, fresh: &Path) -> Result<Self, GoldenError> {
        let new = read(fresh)?;
        let old = match fs::read(&golden) {
            Ok(bytes) => Some(bytes),
            Err(missing) if missing.kind() == ErrorKind::NotFound => None,
            Err(source) => return Err(GoldenError::Io { attempt: "read", path: golden, source }),
        };
        let standing = match &old {
            None => Standing::Missing,
            Some(old) if *old == new => Standing::Same,
            Some(_) => differing(&golden, fresh)?,
        };
        let size = |bytes: &Vec<u8>| bytes.len() as u64;
        let (bytes_before, bytes) = (old.as_ref().map(size), size(&new));
        Ok(Self { scene: scene.to_owned(), golden, bytes_before, bytes, standing })
    }

    /// Whether no byte differs.
    pub fn is_same(&self) -> bool {
        matches!(self.standing, Standing::Same)
    }

    /// Puts `fresh` in the golden's place, if it is another.
    pub fn bless(&self, fresh: &Path) -> Result<(), GoldenError> {
        if self.is_same() {
            return Ok(());
        }
        let mut file = PartFile::create(&self.golden, true)?;
        let written = file.write_all(&read(fresh)?);
        written.map_err(|source| GoldenError::Io { attempt: "write", path: self.golden.clone(), source })?;
        Ok(file.publish()?)
    }
}

impl Standing {
    /// As tables and JSON call it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Missing => "missing",
            Self::Changed(report) if report.is_same() => "other bytes",
            Self::Changed(_) => "other values",
            Self::Unreadable(_) => "unreadable",
        }
    }

    /// Whether there are values that are not the golden's.
    pub fn has_other_values(&self) -> bool {
        match self {
            Self::Same => false,
            Self::Changed(report) => !report.is_same(),
            Self::Missing | Self::Unreadable(_) => true,
        }
    }
}

/// How the values differ, all of them to the bit: reruns have the same bits on every machine.
fn differing(golden: &Path, fresh: &Path) -> Result<Standing, GoldenError> {
    let exact = Comparison { tolerances: Tolerances::exact(), ..Comparison::default() };
    let new = Side::open(fresh)?;
    // What is wrong from here on is wrong with the golden.
    let report = Side::open(golden).map_err(Into::into).and_then(|old| exact.run(old, new));
    Ok(report
        .map_or_else(|error| Standing::Unreadable(error.to_string()), |report| Standing::Changed(Box::new(report))))
}

fn read(path: &Path) -> Result<Vec<u8>, GoldenError> {
    fs::read(path).map_err(|source| GoldenError::Io { attempt: "read", path: path.into(), source })
}
