use std::path::Path;

use super::error::GoldenError;
use crate::recording::{Finished, Recorder, Subject};
use crate::scenario::Plan;

/// Writes `plan` to each of `paths`, as goldens are: columns and words, nothing to look at.
pub fn record(plan: &Plan, paths: &[impl AsRef<Path>]) -> Result<Vec<Finished>, GoldenError> {
    let files = Recorder::claim(paths, false)?;
    let mut recorder = Recorder::begin(&Subject::compact(plan), files)?;
    let mut run = plan.start()?;
    while let Some(samples) = run.next_batch()? {
        recorder.write(samples)?;
    }
    Ok(recorder.finish()?)
}
