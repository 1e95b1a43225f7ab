//! Whether recordings fit on the disk: asked before the run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::args::FileFormat;
use super::commands::convert::has_extension;
use super::report::size;
use crate::recording::Survey;
use crate::scenario::{Plan, Watched};
use crate::telemetry::Channel;

/// There is less room than the recordings would take.
#[derive(Debug, Error)]
#[error(
    "the recordings would take about {needed}, and {folder} has {free} free: record fewer channels, less often, or elsewhere",
    needed = size(*needed), folder = folder.display(), free = size(*free)
)]
pub struct NoRoom {
    folder: PathBuf,
    needed: u64,
    free: u64,
}

impl FileFormat {
    /// Bytes that a recorded value takes in a long run, packed and with its share of times, pictures and indexes.
    const fn bytes_per_value(self) -> u64 {
        match self {
            Self::Mcap => 8,
            Self::Rrd => 27,
            Self::Csv => 21,
        }
    }
}

/// Refuses recordings for which `folder`, which is there, has no room; where the system does not tell, there is.
pub fn check(plans: &[Plan], formats: &[FileFormat], folder: &Path) -> Result<(), NoRoom> {
    fits(plans.iter().map(|plan| estimate(plan, formats)).fold(0, u64::saturating_add), free(folder), folder)
}

fn fits(needed: u64, free: Option<u64>, folder: &Path) -> Result<(), NoRoom> {
    match free {
        Some(free) if needed > free => Err(NoRoom { folder: folder.to_owned(), needed, free }),
        _ => Ok(()),
    }
}

/// The same for a recording that is written anew: each output beside those of its folder, which need not be there.
pub fn check_anew(survey: &Survey, outputs: &[PathBuf]) -> Result<(), NoRoom> {
    let mut needed: BTreeMap<&Path, u64> = BTreeMap::new();
    for output in outputs {
        let formats = [FileFormat::Mcap, FileFormat::Rrd, FileFormat::Csv];
        let format = formats.into_iter().find(|format| has_extension(output, format.extension()));
        let parent = output.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let channels = survey.heading.bodies.iter().flat_map(|body| &body.channels);
        let bytes = format.map_or(0, |format| bytes(survey.samples, channels, &[format]));
        let of_folder = needed.entry(parent).or_default();
        *of_folder = of_folder.saturating_add(bytes);
    }
    needed.into_iter().try_for_each(|(folder, needed)| fits(needed, free(folder), folder))
}

/// Bytes of all files of a run, about.
fn estimate(plan: &Plan, formats: &[FileFormat]) -> u64 {
    bytes(plan.grid.len(), plan.watched().flat_map(Watched::channels), formats)
}

fn bytes<'a>(samples: u64, channels: impl Iterator<Item = &'a Channel>, formats: &[FileFormat]) -> u64 {
    let values: usize = channels.map(|channel| channel.row().components.len()).sum();
    let each: u64 = formats.iter().map(|format| format.bytes_per_value()).sum();
    samples.saturating_mul(values as u64).saturating_mul(each)
}

/// Bytes that this program may still write.
#[cfg(unix)]
fn free(folder: &Path) -> Option<u64> {
    // What has no blocks at all, such as /proc, is no disk.
    let disk = rustix::fs::statvfs(folder).ok().filter(|disk| disk.f_blocks > 0)?;
    Some(disk.f_bavail.saturating_mul(disk.f_frsize))
}

#[cfg(not(unix))]
fn free(_: &Path) -> Option<u64> {
    None
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::recording::{Recorder, Subject};
    use crate::scenario::Scenario;

    #[test]
    fn estimates_are_right_to_a_third() {
        let assignments = ["duration_s=60", "sample_every_s=0.001"].map(str::to_owned);
        let scenario = Scenario::named("dzhanibekov", &assignments).expect("a scene");
        let plan = Plan::new(&scenario).expect("a plan");
        let folder = tempfile::tempdir().expect("a folder");
        for format in [FileFormat::Mcap, FileFormat::Rrd, FileFormat::Csv] {
            let path = folder.path().join(format!("run.{}", format.extension()));
            let subject = Subject::of(&plan);
            let mut recorder =
                Recorder::begin(&subject, Recorder::claim(std::slice::from_ref(&path), false).expect("a free name"))
                    .expect("room");
            let mut run = plan.start().expect("a run");
            while let Some(samples) = run.next_batch().expect("a motion") {
                recorder.write(samples).expect("room");
            }
            recorder.finish().expect("room");
            let (found, told) = (fs::metadata(&path).expect("recorded").len(), estimate(&plan, &[format]));
            assert!(3 * found < 4 * told && 3 * told < 4 * found, "{format:?}: {found} bytes, {told} estimated");
        }
    }

    #[test]
    fn what_does_not_fit_is_refused_in_words() {
        let folder = Path::new("out");
        assert!(fits(1000, Some(1000), folder).is_ok());
        assert!(fits(u64::MAX, None, folder).is_ok());
        let message = fits(340_000_000_000, Some(36_000_000_000), folder).expect_err("too large").to_string();
        assert!(message.starts_with("the recordings would take about 340.0 GB, and out has 36.0 GB free"), "{message}");
    }

    #[cfg(unix)]
    #[test]
    fn the_system_tells_what_is_free() {
        assert!(free(Path::new("/")).is_some());
        assert_eq!(free(Path::new("/there is no such folder")), None);
        assert_eq!(free(Path::new("/proc")), None, "there is none, or it is no disk");
    }
}
