use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use re_sdk_types::archetypes::{TextDocument, TextLog};
use re_sdk_types::components::TextLogLevel;

use super::columns::{sim_time, timelines};
use super::gathered::Gathered;
use super::moving::Moving;
use super::particles::Particles;
use super::plots::Plots;
use super::scaled::Scaled;
use super::stream::{Rows, Store, Stream};
use super::{about, identity, layout, markers, plain, statics, words};
use crate::recording::{Interruption, PartFile, RecordingError, Sink, Subject};
use crate::scenario::{Plan, nanoseconds};
use crate::telemetry::Samples;

/// Entity of the document that says that a run was stopped, and where.
const INTERRUPTION: &str = "/interruption";

/// An `.rrd` being written to a file.
pub struct RerunFile {
    path: PathBuf,
    /// `None` once the file is handed back.
    recording: Option<RerunStream<PartFile>>,
}

/// An `.rrd` being written: layout and constants at once, columns batch by batch, the footer at the end.
pub(in crate::recording) struct RerunStream<W> {
    stream: Stream<W>,
    store: Store,
    plots: Plots,
    moving: Option<Moving>,
    gathered: Gathered,
}

impl RerunFile {
    /// Writes what comes before the first sample.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn create(subject: &Subject, file: PartFile) -> Result<Self, RecordingError> {
        let path = file.path().to_path_buf();
        let recording = Some(RerunStream::begin(subject, file, path.clone())?);
        Ok(Self { path, recording })
    }
}

impl<W: Write> RerunStream<W> {
    /// Writes what comes before the first sample; `path` is what messages name.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn begin(subject: &Subject, writer: W, path: PathBuf) -> Result<Self, RecordingError> {
        let begin = if subject.is_compact { Stream::begin_compressed } else { Stream::begin };
        let mut stream = begin(writer, path)?;
        let recording = identity::recording(subject).map_err(|reason| stream.refused(reason))?;
        let store = stream.open(recording)?;
        if !subject.is_compact {
            write_layout(&mut stream, subject)?;
        }

        words::write(&mut stream, store, subject)?;
        if let Some((plan, picture)) = subject.drawing {
            stream.once(store, "/about", &[], &about::document(plan, picture))?;
            statics::write(&mut stream, store, plan, picture)?;
            write_events(&mut stream, store, plan)?;
            markers::write(&mut stream, store, plan)?;
        } else {
            plain::write(&mut stream, store, subject)?;
        }
        let plots = Plots::begin(&mut stream, store, subject)?;
        let moving = match subject.drawing {
            Some((plan, picture)) => {
                let scaled = Scaled::begin(&mut stream, store, plan, picture)?;
                let particles = Particles::begin(&mut stream, store, plan, picture)?;
                Some(Moving::new(plan, picture, scaled, particles))
            }
            None => None,
        };
        Ok(Self { stream, store, plots, moving, gathered: Gathered::new(subject) })
    }

    /// Takes one batch.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        if self.gathered.is_idle() {
            return self.keep(samples);
        }
        if self.gathered.add(samples) { self.complete() } else { Ok(()) }
    }

    /// Writes what is still in memory.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn complete(&mut self) -> Result<(), RecordingError> {
        let gathered = self.gathered.take();
        let kept = self.keep(&gathered);
        self.gathered.give_back(gathered);
        kept
    }

    /// Tells that the run was stopped: in the log, at the time of the last sample, and once for all as a document.
    fn tell_interruption(&mut self, end: &Interruption) -> Result<(), RecordingError> {
        let words = format!("interrupted: {}", end.in_words());
        let at_the_end = [sim_time(vec![nanoseconds(end.to_s)])];
        let entry = TextLog::new(words.as_str()).with_level(TextLogLevel::WARN);
        self.stream.once(self.store, "/log", &at_the_end, &entry)?;
        self.stream.once(self.store, INTERRUPTION, &[], &TextDocument::new(words))
    }

    /// Writes a chunk's worth of samples.
    fn keep(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        if samples.is_empty() {
            return Ok(());
        }
        let steps = (samples.first_index..).take(samples.len()).map(u64::cast_signed).collect();
        let times = timelines(samples.stamps_ns.clone(), steps);
        let rows = Rows { count: samples.len(), times: &times };
        self.plots.write(&mut self.stream, self.store, rows, samples)?;
        match &mut self.moving {
            Some(moving) => moving.write(&mut self.stream, self.store, samples),
            None => Ok(()),
        }
    }
}

impl Sink for RerunFile {
    fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        let Some(recording) = &mut self.recording else { return Err(gone(&self.path)) };
        recording.write(samples)?;
        recording.stream.flush_if_due()
    }

    fn finish(mut self: Box<Self>) -> Result<PartFile, RecordingError> {
        let Some(mut recording) = self.recording.take() else { return Err(gone(&self.path)) };
        recording.complete()?;
        recording.stream.end()
    }

    fn interrupt(mut self: Box<Self>, end: &Interruption) -> Result<PartFile, RecordingError> {
        let Some(mut recording) = self.recording.take() else { return Err(gone(&self.path)) };
        recording.complete()?;
        recording.tell_interruption(end)?;
        recording.stream.end()
    }
}

fn gone(path: &Path) -> RecordingError {
    RecordingError::Io { attempt: "write", path: path.into(), source: ErrorKind::BrokenPipe.into() }
}

impl Drop for RerunFile {
    /// A run that is given up leaves what it has.
    fn drop(&mut self) {
        if let Some(recording) = &mut self.recording {
            // Nobody is left to tell, and after a failure nothing is written.
            let _ = recording.complete();
        }
    }
}

/// Logs what is to be seen where, in a store of its own.
fn write_layout<W: Write>(stream: &mut Stream<W>, subject: &Subject) -> Result<(), RecordingError> {
    let blueprint = identity::blueprint(subject).map_err(|reason| stream.refused(reason))?;
    let blueprint = stream.open(blueprint)?;
    match subject.drawing {
        Some((plan, picture)) => layout::write(stream, blueprint, plan, picture)?,
        None => plain::write_layout(stream, blueprint, subject)?,
    }
    stream.activate(blueprint)
}

/// Logs what happens to the bodies, in one chunk.
fn write_events<W: Write>(stream: &mut Stream<W>, store: Store, plan: &Plan) -> Result<(), RecordingError> {
    if plan.events.is_empty() {
        return Ok(());
    }
    let times = [sim_time(plan.events.iter().map(|event| nanoseconds(event.time_s)).collect())];
    let columns = about::events(plan).columns_of_unit_batches().map_err(|error| stream.refused(error))?;
    stream.columns(store, "/log", Rows { count: plan.events.len(), times: &times }, columns)
}
