use std::path::{Path, PathBuf};

use super::format::{Format, is_part};
use super::{RecordingError, csv_file, mcap_file, rerun_file};
use crate::scenario::{MOST_BODIES, Plan, nanoseconds};
use crate::telemetry::{BodySamples, Channel, Samples};

/// A recording that is read back: the same columns as were written, to the bit, whatever the format.
///
/// Like a [`Run`](crate::scenario::Run) it lends its own buffers batch by batch: memory is flat at any length. The file is not
/// trusted: every length is held against what is there, every check sum against the bytes, every sample against the form
/// that it must have. A `NAME.part` is read as far as it goes.
///
/// ```no_run
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut recording = polhode::recording::Recording::open("spin.mcap".as_ref())?;
/// while let Some(samples) = recording.next_batch()? {
///     println!("{} samples from {} s", samples.len(), samples.times_s[0]);
/// }
/// # Ok(())
/// # }
/// ```
pub struct Recording {
    path: PathBuf,
    heading: Heading,
    source: Box<dyn Source>,
    samples: Samples,
    last_s: Option<f64>,
    state: State,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Reading,
    Ended,
    Failed,
}

/// What a recording says before its first sample.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Heading {
    /// The bodies in the order of the scene, and then what is recorded beside them: see [`RecordedBody::is_point`].
    pub bodies: Vec<RecordedBody>,
    /// What made it, from what, how: name and value, as far as the format holds them.
    pub provenance: Vec<(String, String)>,
    /// The scene as text, if the format holds it.
    pub scene: Option<String>,
}

/// One body of a recording, or a point of one.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RecordedBody {
    /// Its name; of a `.csv` with a single body, which does not tell it, `body`.
    pub name: String,
    /// What was recorded of it; names, units and frames are in [`Channel::row`].
    pub channels: Vec<Channel>,
    /// What was measured of its error: name and value, if anything was and the format holds it.
    pub certificate: Vec<(String, String)>,
}

/// What each format does to be read: its file after the heading.
pub(super) trait Source {
    /// Appends up to `most` samples to empty buffers (or what the file holds together): times and columns. None is the
    /// end.
    fn fill(&mut self, most: usize, samples: &mut Samples) -> Result<(), RecordingError>;

    /// Whether what was read ends as a whole recording does, once it has ended.
    fn is_whole(&self) -> bool;
}

/// A heading, and what follows it.
pub(super) type Opened = (Heading, Box<dyn Source>);

impl Recording {
    /// Numbers in a batch at most.
    const NUMBERS: usize = 1 << 22;
    /// Latest time, s: in whole ns it must fit into 64 bits.
    const LATEST_S: f64 = 9.2e9;

    /// Opens a recording and reads its heading, the format by extension.
    ///
    /// # Errors
    /// If it cannot be read, is damaged, is no recording of this crate, or of a format that this build leaves out.
    pub fn open(path: &Path) -> Result<Self, RecordingError> {
        let name = if is_part(path) { path.with_extension("") } else { path.into() };
        let (heading, source) = match Format::of(&name)? {
            Format::Mcap => mcap_file::open(path)?,
            Format::Rrd => rerun_file::open(path)?,
            Format::Csv => csv_file::open(path)?,
        };
        let samples = heading.samples();
        Ok(Self { path: path.into(), heading, source, samples, last_s: None, state: State::Reading })
    }

    /// Bodies, provenance, certificates.
    #[must_use]
    pub fn heading(&self) -> &Heading {
        &self.heading
    }

    /// The next samples, or `None` at the end.
    ///
    /// # Errors
    /// If the file cannot be read or is damaged, cut off (and no `.part`), of another form, or its times do not ascend
    /// from 0 or later. Nothing is read after an error.
    pub fn next_batch(&mut self) -> Result<Option<&Samples>, RecordingError> {
        match self.state {
            State::Ended => return Ok(None),
            State::Failed => return Err(self.refuse("an earlier batch could not be read".into())),
            State::Reading => {}
        }
        self.state = State::Failed;
        self.samples.first_index += self.samples.len() as u64;
        self.samples.clear();
        self.source.fill(self.heading.batch(), &mut self.samples)?;
        self.check_times()?;
        self.samples.stamps_ns.extend(self.samples.times_s.iter().map(|time| nanoseconds(*time)));
        self.state = if self.samples.is_empty() { State::Ended } else { State::Reading };
        Ok((!self.samples.is_empty()).then_some(&self.samples))
    }

    /// Whether the recording is whole: known once [`Self::next_batch`] has returned `None`, and never so of a `.part`
    /// whose end is missing, or of what holds fewer samples than it says were planned, as that of an interrupted run does.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        // At the end, this is how many samples there were.
        let read = self.samples.first_index;
        let is_complete = self.heading.planned_samples().is_none_or(|planned| planned == read);
        self.state == State::Ended && self.source.is_whole() && is_complete
    }

    fn check_times(&mut self) -> Result<(), RecordingError> {
        for (index, time) in (self.samples.first_index..).zip(&self.samples.times_s) {
            if !(0.0..=Self::LATEST_S).contains(time) {
                return Err(self.refuse(format!("sample {index} is at {time} s: times are from 0 to 9.2e9 s")));
            }
            if let Some(last) = self.last_s.filter(|last| time <= last) {
                return Err(self.refuse(format!("sample {index} is at {time} s, after one at {last} s: times ascend")));
            }
            self.last_s = Some(*time);
        }
        Ok(())
    }

    /// A complaint about this file.
    pub(super) fn refuse(&self, reason: String) -> RecordingError {
        RecordingError::Decode { path: self.path.clone(), reason }
    }
}

impl RecordedBody {
    /// Whether it is a point of a body, such as a probe: its name is the body's, a slash and its own.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.name.contains('/')
    }
}

impl Heading {
    /// Most bodies: as many as an `.mcap` has topics.
    pub(super) const MOST_BODIES: usize = MOST_BODIES;

    /// What it says of itself under `name`.
    #[must_use]
    pub fn fact(&self, name: &str) -> Option<&str> {
        self.provenance.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    /// How many samples there were to be, if it tells.
    #[must_use]
    pub fn planned_samples(&self) -> Option<u64> {
        self.fact("samples")?.parse().ok()
    }

    /// Empty buffers for every body.
    pub(super) fn samples(&self) -> Samples {
        let bodies = self.bodies.iter().map(|body| BodySamples::new(&body.channels)).collect();
        Samples { bodies, ..Samples::default() }
    }

    /// Samples in a batch: fewer of very many columns.
    fn batch(&self) -> usize {
        let columns = self.bodies.iter().flat_map(|body| &body.channels).map(|channel| channel.width());
        (Recording::NUMBERS / columns.sum::<usize>().max(1)).clamp(1, Plan::BATCH)
    }
}

impl std::fmt::Debug for Recording {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Recording").field("path", &self.path).field("heading", &self.heading).finish_non_exhaustive()
    }
}
