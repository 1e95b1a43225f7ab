use std::path::{Path, PathBuf};

use super::Conversion;
use crate::recording::format::{Format, is_part};
use crate::recording::part_file::hold;
use crate::recording::{Finished, PartFile, Recording, RecordingError, Survey};

/// What came of a run that was cut off.
#[derive(Debug)]
pub struct Recovered {
    /// The recording that it is now.
    pub file: Finished,
    /// What was read of the part file: how many samples, until when.
    pub conversion: Conversion,
    /// How many samples were planned, if the format tells.
    pub planned: Option<u64>,
    /// The part file, if it is still there.
    pub part: Option<PathBuf>,
}

/// Makes a whole recording of the part file that a killed run left, under `output`, by default the name that it was to
/// have. The samples are the first of the run, to the bit; what made it, and how many samples were kept of how many, is
/// in it. With nothing missing it is what the run would have given.
///
/// It is written as `NAME.recovered.mcap.part` beside that name. Once the recording is durable under its name, the part
/// file is removed, if the format is the same.
///
/// # Errors
/// If it is no part file, or another run is writing it; if it holds no sample, or is damaged before its end; if `output`
/// exists and `overwrite` is not set, or cannot be written.
pub fn recover(part: &Path, output: Option<&Path>, overwrite: bool) -> Result<Recovered, RecordingError> {
    if !is_part(part) {
        let rule = "what a killed run leaves ends in .part".into();
        return Err(RecordingError::NotRepresentable { path: part.into(), rule });
    }
    let name = part.with_extension("");
    let output = output.unwrap_or(&name);
    let is_same_format = Format::of(output)? == Format::of(&name)?;
    let held = hold(part)?;
    let survey = Survey::of(&mut Recording::open(part)?)?;
    if survey.sampling().samples == 0 {
        return Err(RecordingError::NothingKept { path: part.into() });
    }
    let planned = survey.heading.planned_samples();
    let conversion = Conversion::of_part(part, survey);
    let file = PartFile::create_apart(output, "recovered", overwrite)?;
    let file = conversion.write_to(vec![file])?.remove(0);
    if is_same_format {
        std::fs::remove_file(part).map_err(|source| RecordingError::Io {
            attempt: "remove",
            path: part.into(),
            source,
        })?;
    }
    drop(held);
    Ok(Recovered { file, conversion, planned, part: (!is_same_format).then(|| part.into()) })
}
