use crate::comparison::compare::CompareError;
use crate::comparison::compare::report::Coverage;
use crate::recording::Recording;
use crate::scenario::Run;
use crate::telemetry::Samples;

/// Where samples come from that have times of their own.
pub(in crate::comparison) enum Feed<'a> {
    Recording(Recording),
    Run(Run<'a>),
}

/// The part of the time that is compared, s, both ends in it.
#[derive(Debug, Clone, Copy)]
pub(in crate::comparison) struct Window {
    pub from_s: f64,
    pub to_s: f64,
}

/// Goes through the samples of one side that are within the window, batch by batch.
pub(in crate::comparison) struct Cursor<'a> {
    feed: Feed<'a>,
    window: Window,
    shift_s: f64,
    samples: Samples,
    /// The next sample of the batch, and the end of those within the window.
    at: usize,
    end: usize,
    coverage: Coverage,
}

impl<'a> Cursor<'a> {
    /// Whose clock is put forward by `shift_s`.
    pub fn new(feed: Feed<'a>, window: Window, shift_s: f64) -> Self {
        let coverage = Coverage::default();
        Self { feed, window, shift_s, samples: Samples::default(), at: 0, end: 0, coverage }
    }

    /// Makes sure that there is a next sample; false where there is none any more.
    pub fn refill(&mut self) -> Result<bool, CompareError> {
        while self.at == self.end {
            let batch = match &mut self.feed {
                Feed::Recording(recording) => recording.next_batch()?,
                Feed::Run(run) => run.next_batch()?,
            };
            let Some(batch) = batch else { return Ok(false) };
            self.samples.clone_from(batch);
            if self.shift_s != 0.0 {
                self.samples.times_s.iter_mut().for_each(|time_s| *time_s += self.shift_s);
            }
            let times_s = &self.samples.times_s;
            self.at = times_s.partition_point(|time_s| *time_s < self.window.from_s);
            self.end = times_s.partition_point(|time_s| *time_s <= self.window.to_s).max(self.at);
            self.coverage.include(&times_s[self.at..self.end]);
        }
        Ok(true)
    }

    /// Times of the samples that are next and in memory, s.
    pub fn times_s(&self) -> &[f64] {
        &self.samples.times_s[self.at..self.end]
    }

    /// The batch, and which of its samples is next.
    pub fn samples(&self) -> (&Samples, usize) {
        (&self.samples, self.at)
    }

    /// Goes on by so many samples, of those in memory.
    pub fn advance(&mut self, count: usize) {
        self.at = (self.at + count).min(self.end);
    }

    /// What part of the time it goes through.
    pub fn window(&self) -> Window {
        self.window
    }

    /// Where samples have been so far.
    pub fn coverage(&self) -> Coverage {
        self.coverage
    }
}
