use super::{Interruption, PartFile, RecordingError};
use crate::telemetry::Samples;

/// A place that keeps samples.
pub trait Sink {
    /// Keeps one batch.
    ///
    /// # Errors
    /// If it cannot; the sink is then of no further use, what was kept before stays readable.
    fn write(&mut self, samples: &Samples) -> Result<(), RecordingError>;

    /// Completes the recording and hands back its file, still under its `.part` name: the [`Recorder`](super::Recorder)
    /// publishes the files of a run once all of them are complete.
    ///
    /// # Errors
    /// If it cannot; the part file then stays, readable as far as it goes.
    fn finish(self: Box<Self>) -> Result<PartFile, RecordingError>;

    /// Ends the recording of a run that was stopped, so that it is read by its index like a whole one, and says in it that
    /// it is not (a `.csv` has no room for words). Hands back its file, which stays a `.part`.
    ///
    /// # Errors
    /// As [`Self::finish`].
    fn interrupt(self: Box<Self>, end: &Interruption) -> Result<PartFile, RecordingError>;
}
