use std::path::{Path, PathBuf};

use super::csv_file::CsvFile;
use super::format::Format;
use super::mcap_file::McapFile;
use super::picture::Picture;
use super::rerun_file::RerunFile;
use super::{Interruption, PartFile, RecordingError, Sink, Subject};
use crate::scenario::Plan;
use crate::telemetry::Samples;

/// The recordings of one run, all or none: what is written goes to each, and the names are given together at the end.
///
/// Dropped before [`Self::finish`], it leaves `.part` files, readable as far as the run got.
pub struct Recorder {
    sinks: Vec<Box<dyn Sink>>,
    /// How far it has come.
    reached: Interruption,
}

/// A recording that is whole, durable and stands under its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finished {
    /// Its name.
    pub path: PathBuf,
    /// Its size.
    pub bytes: u64,
}

impl Recorder {
    /// Opens a recording of `plan` at each path: `.mcap`, `.rrd` or `.csv`. All files are created, as `NAME.part`,
    /// before the first is written to.
    ///
    /// # Errors
    /// If a path has another extension, is named twice, exists (unless `overwrite`), is being written by another run,
    /// or cannot be created; if this build leaves the format out; if the motion cannot be looked over for a picture.
    pub fn create(plan: &Plan, paths: &[impl AsRef<Path>], overwrite: bool) -> Result<Self, RecordingError> {
        let files = Self::claim(paths, overwrite)?;
        // Scales and camera cost a preview of the run.
        let picture = draws(&files).then(|| Picture::of(plan)).transpose()?;
        let subject = picture.as_ref().map_or_else(|| Subject::of(plan), |picture| Subject::drawn(plan, picture));
        Self::begin(&subject, files)
    }

    /// A part file for each path, once all of the paths are found right: for what is found out before a recording can
    /// [`begin`](Self::begin), so that names that are taken do not cost its time.
    ///
    /// # Errors
    /// If a path has another extension, is named twice, exists (unless `overwrite`), is being written by another run,
    /// or cannot be created.
    pub fn claim(paths: &[impl AsRef<Path>], overwrite: bool) -> Result<Vec<PartFile>, RecordingError> {
        let paths: Vec<&Path> = paths.iter().map(AsRef::as_ref).collect();
        refuse_duplicates(&paths)?;
        paths.iter().try_for_each(|path| Format::of(path).map(drop))?;
        paths.iter().map(|path| PartFile::create(path, overwrite)).collect()
    }

    /// Begins a recording of `subject` in each of `files`, the format by the extension that it will have.
    ///
    /// # Errors
    /// If a file has another extension, or cannot be written; if this build leaves the format out.
    pub fn begin(subject: &Subject, files: Vec<PartFile>) -> Result<Self, RecordingError> {
        let open = |file: PartFile| -> Result<Box<dyn Sink>, RecordingError> {
            Ok(match Format::of(file.path())? {
                Format::Mcap => Box::new(McapFile::create(subject, file)?),
                Format::Rrd => Box::new(RerunFile::create(subject, file)?),
                Format::Csv => Box::new(CsvFile::create(subject, file)?),
            })
        };
        let sinks = files.into_iter().map(open).collect::<Result<Vec<_>, _>>()?;
        let reached =
            Interruption { samples: 0, planned: Some(subject.sampling.samples), to_s: subject.sampling.from_s };
        Ok(Self { sinks, reached })
    }

    /// Adds one batch to every recording.
    ///
    /// # Errors
    /// If one of them cannot take it; the recorder is then of no further use.
    pub fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        self.reached.samples += samples.len() as u64;
        self.reached.to_s = samples.times_s.last().copied().unwrap_or(self.reached.to_s);
        self.sinks.iter_mut().try_for_each(|sink| sink.write(samples))
    }

    /// Ends every recording where it is, for a run that is stopped. None gets its name: each stays a `.part`, which is read
    /// by its index, says that it is not the whole run, and is made one of what there is by [`recover`](super::recover).
    /// Without a sample there is nothing to keep, and the parts are removed.
    ///
    /// # Errors
    /// If one cannot be ended or brought to disk; the `.part` files then stay, readable as far as they go.
    pub fn interrupt(self) -> Result<(Interruption, Vec<PathBuf>), RecordingError> {
        let end = self.reached;
        let mut files = self.sinks.into_iter().map(|sink| sink.interrupt(&end)).collect::<Result<Vec<_>, _>>()?;
        if end.samples == 0 {
            files.into_iter().try_for_each(PartFile::discard)?;
            return Ok((end, Vec::new()));
        }
        files.iter_mut().try_for_each(PartFile::sync)?;
        Ok((end, files.iter().map(|file| file.part().to_path_buf()).collect()))
    }

    /// Completes every recording, then gives each its name.
    ///
    /// # Errors
    /// If one cannot be completed or brought to disk: then none gets its name, and the `.part` files stay. Giving the
    /// names comes last; if one is refused, those before it have theirs.
    pub fn finish(self) -> Result<Vec<Finished>, RecordingError> {
        let mut files = self.sinks.into_iter().map(Sink::finish).collect::<Result<Vec<_>, _>>()?;
        files.iter_mut().try_for_each(PartFile::sync)?;
        files.into_iter().map(publish).collect()
    }
}

/// Whether one of the files will hold pictures.
pub(super) fn draws(files: &[PartFile]) -> bool {
    files.iter().any(|file| !matches!(Format::of(file.path()), Ok(Format::Csv)))
}

fn publish(file: PartFile) -> Result<Finished, RecordingError> {
    let finished = Finished { path: file.path().into(), bytes: file.bytes() };
    file.publish()?;
    Ok(finished)
}

fn refuse_duplicates(paths: &[&Path]) -> Result<(), RecordingError> {
    for (index, path) in paths.iter().enumerate() {
        if paths[..index].contains(path) {
            return Err(RecordingError::NotRepresentable { path: path.into(), rule: "named twice".into() });
        }
    }
    Ok(())
}
