use crate::recording::Subject;
use crate::scenario::Plan;
use crate::telemetry::Samples;

/// Batches on their way to longer chunks. The footer tells of every chunk, and the writer keeps that in memory: the more
/// samples there will be, the longer the chunks.
pub(super) struct Gathered {
    rows: usize,
    samples: Samples,
}

impl Gathered {
    /// Batches that make one long recording; beyond them chunks grow.
    const BATCHES: u64 = 512;
    /// Numbers in a chunk's worth of samples at most: 16 MiB.
    const NUMBERS: usize = 1 << 21;

    pub(super) fn new(subject: &Subject) -> Self {
        let channels = subject.heading.bodies.iter().flat_map(|body| &body.channels);
        let columns: usize = channels.map(|channel| channel.width()).sum();
        let mut rows = Plan::BATCH;
        while subject.sampling.samples / rows as u64 > Self::BATCHES && 2 * rows * columns.max(1) <= Self::NUMBERS {
            rows *= 2;
        }
        Self { rows, samples: Samples::default() }
    }

    /// Whether batches are chunks: then nothing is gathered.
    pub(super) fn is_idle(&self) -> bool {
        self.rows == Plan::BATCH
    }

    /// Adds a batch; whether there is enough for a chunk.
    pub(super) fn add(&mut self, samples: &Samples) -> bool {
        self.samples.append(samples);
        self.samples.len() >= self.rows
    }

    /// What was gathered, to be written.
    pub(super) fn take(&mut self) -> Samples {
        std::mem::take(&mut self.samples)
    }

    /// Takes the memory of what was written for what comes.
    pub(super) fn give_back(&mut self, mut written: Samples) {
        written.clear();
        self.samples = written;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::{RecordedBody, Sampling};
    use crate::telemetry::Channel;

    fn rows(samples: u64, bodies: usize) -> usize {
        let mut subject = Subject {
            name: String::new(),
            title: String::new(),
            heading: crate::recording::Heading::default(),
            sampling: Sampling { samples, from_s: 0.0, to_s: 1.0, interval_s: None },
            identity: String::new(),
            drawing: None,
            is_compact: false,
        };
        let body = RecordedBody { channels: Channel::ALL.to_vec(), ..RecordedBody::default() };
        subject.heading.bodies.resize(bodies, body);
        Gathered::new(&subject).rows
    }

    #[test]
    fn chunks_are_few_however_long_the_recording_and_no_larger_than_memory_allows() {
        assert_eq!(rows(1_000_000, 1), 8192);
        assert_eq!(rows(4_300_000, 1), 16384);
        let columns: usize = Channel::ALL.iter().map(|channel| channel.width()).sum();
        for bodies in [1, 2, 1000] {
            let rows = rows(1 << 50, bodies);
            assert!(rows == 8192 || rows * bodies * columns <= 1 << 21, "{bodies} bodies: {rows}");
        }
    }
}
