use super::{Heading, Recording, RecordingError};
use crate::telemetry::{BodySamples, Channel};

/// A recording read from end to end: what it says of itself, how many samples, over which time, between which values.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// Bodies, provenance, certificates.
    pub heading: Heading,
    /// How many samples.
    pub samples: u64,
    /// Time of the first, s.
    pub from_s: Option<f64>,
    /// Time of the last, s.
    pub to_s: Option<f64>,
    /// Of every column of every body, in order.
    pub ranges: Vec<Range>,
}

/// Between which values a column is, in the unit of its channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Number of the body.
    pub body: usize,
    /// Of which channel.
    pub channel: Channel,
    /// Which of its columns.
    pub component: usize,
    /// The smallest number; `None` where there is none.
    pub least: Option<f64>,
    /// The largest number; `None` where there is none.
    pub greatest: Option<f64>,
}

impl Survey {
    /// Reads `recording` to its end.
    ///
    /// # Errors
    /// As [`Recording::next_batch`].
    pub fn of(recording: &mut Recording) -> Result<Self, RecordingError> {
        let heading = recording.heading().clone();
        let mut ranges = Vec::new();
        for (body, recorded) in heading.bodies.iter().enumerate() {
            for channel in recorded.channels.iter().copied() {
                let range = |component| Range { body, channel, component, least: None, greatest: None };
                ranges.extend((0..channel.width()).map(range));
            }
        }
        let mut survey = Self { heading, ranges, samples: 0, from_s: None, to_s: None };
        while let Some(samples) = recording.next_batch()? {
            survey.samples += samples.len() as u64;
            survey.from_s = survey.from_s.or(samples.times_s.first().copied());
            survey.to_s = samples.times_s.last().copied();
            let columns = samples.bodies.iter().flat_map(BodySamples::columns);
            for (range, column) in survey.ranges.iter_mut().zip(columns) {
                range.widen(column);
            }
        }
        Ok(survey)
    }
}

impl Range {
    /// The column's name, with unit.
    #[must_use]
    pub fn name(&self) -> String {
        self.channel.row().column_name(self.component)
    }

    fn widen(&mut self, column: &[f64]) {
        let numbers = || column.iter().copied().filter(|value| !value.is_nan());
        self.least = numbers().chain(self.least).reduce(f64::min);
        self.greatest = numbers().chain(self.greatest).reduce(f64::max);
    }
}
