/// The sample times of a run: `n · every_s`, or a list.
#[derive(Debug, Clone, PartialEq)]
pub enum Grid {
    /// Sample n is at n · `every_s`, never a running sum.
    Uniform {
        /// s.
        every_s: f64,
        /// How many samples.
        count: u64,
    },
    /// Ascending times, s.
    List(Vec<f64>),
}

impl Grid {
    /// How many samples.
    #[must_use]
    pub fn len(&self) -> u64 {
        match self {
            Self::Uniform { count, .. } => *count,
            Self::List(times) => times.len() as u64,
        }
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Time of sample `index`, s. An index past the end gives the last time's continuation or the last time.
    #[must_use]
    pub fn time(&self, index: u64) -> f64 {
        match self {
            Self::Uniform { every_s, .. } => exact(index) * every_s,
            Self::List(times) => {
                let index = usize::try_from(index).unwrap_or(usize::MAX).min(times.len().saturating_sub(1));
                times.get(index).copied().unwrap_or(0.0)
            }
        }
    }

    /// Time of the last sample, s.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.time(self.len().saturating_sub(1))
    }

    /// Mean time between samples, s; infinite for a single sample.
    #[must_use]
    pub fn mean_interval(&self) -> f64 {
        match self {
            Self::Uniform { every_s, .. } => *every_s,
            Self::List(times) => (self.end() - self.time(0)) / exact(times.len().saturating_sub(1) as u64),
        }
    }

    /// Numbers of samples spread evenly over the first `count`, both ends among them: all, or `most` of at least two.
    #[must_use]
    pub fn spread(count: u64, most: u64) -> Vec<u64> {
        if count <= most {
            return (0..count).collect();
        }
        (0..most).map(|n| n * (count - 1) / (most - 1)).collect()
    }

    /// Puts the times of samples `first..first + count` (as far as there are) into `times`.
    pub fn fill(&self, first: u64, count: usize, times: &mut Vec<f64>) {
        let end = self.len().min(first.saturating_add(count as u64));
        times.clear();
        times.extend((first..end).map(|index| self.time(index)));
    }
}

/// A sample number as f64: exact, as the plan admits no more than 2⁵³ samples.
#[expect(clippy::cast_precision_loss)]
fn exact(index: u64) -> f64 {
    index as f64
}
