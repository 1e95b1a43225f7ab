use super::{Heading, Recording, RecordingError, Sampling};
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
    /// The interval, s, if sample n is at n times it, rounded once.
    pub interval_s: Option<f64>,
    /// Whether it ends as a whole recording does.
    pub is_whole: bool,
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
        let (from_s, to_s, interval_s) = (None, None, None);
        let mut survey = Self { heading, ranges, samples: 0, from_s, to_s, interval_s, is_whole: false };
        while let Some(samples) = recording.next_batch()? {
            for time_s in &samples.times_s {
                survey.see_time(*time_s);
            }
            let columns = samples.bodies.iter().flat_map(BodySamples::columns);
            for (range, column) in survey.ranges.iter_mut().zip(columns) {
                range.widen(column);
            }
        }
        survey.is_whole = recording.is_whole();
        Ok(survey)
    }

    /// How many samples, and when; of none at all, at 0.
    #[must_use]
    pub fn sampling(&self) -> Sampling {
        let (from_s, to_s) = (self.from_s.unwrap_or(0.0), self.to_s.unwrap_or(0.0));
        Sampling { samples: self.samples, from_s, to_s, interval_s: self.interval_s }
    }

    #[expect(
        clippy::cast_precision_loss,
        reason = "a plan has no more than 2⁵³ samples; where one differs, it is no grid"
    )]
    fn see_time(&mut self, time_s: f64) {
        let is_from_zero = self.from_s.is_some_and(|first| first.to_bits() == 0);
        self.interval_s = match (self.samples, self.interval_s) {
            (0, _) => None,
            (1, _) => is_from_zero.then_some(time_s),
            (number, interval) => interval.filter(|interval| number as f64 * interval == time_s),
        };
        self.from_s = self.from_s.or(Some(time_s));
        self.to_s = Some(time_s);
        self.samples += 1;
    }
}

impl Range {
    /// The column's name, with unit.
    #[must_use]
    pub fn name(&self) -> String {
        self.channel.row().column_name(self.component)
    }

    /// The largest magnitude; 0 where there is no number.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.least.unwrap_or(0.0).abs().max(self.greatest.unwrap_or(0.0).abs())
    }

    fn widen(&mut self, column: &[f64]) {
        let numbers = || column.iter().copied().filter(|value| !value.is_nan());
        self.least = numbers().chain(self.least).reduce(f64::min);
        self.greatest = numbers().chain(self.greatest).reduce(f64::max);
    }
}
