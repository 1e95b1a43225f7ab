use std::error::Error;
use std::path::{Path, PathBuf};

use polhode::recording::Recorder;
use polhode::scenario::Plan;

/// As `polhode run` does, pictures and all.
pub fn record(plan: &Plan, folder: &Path, extensions: &[&str]) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let paths: Vec<PathBuf> = extensions.iter().map(|extension| folder.join("run").with_extension(extension)).collect();
    let mut recorder = Recorder::create(plan, &paths, false)?;
    let mut run = plan.start()?;
    while let Some(samples) = run.next_batch()? {
        recorder.write(samples)?;
    }
    recorder.finish()?;
    Ok(paths)
}
