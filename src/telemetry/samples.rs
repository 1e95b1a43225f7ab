use super::Channel;

/// A batch of samples of every body, as columns. All columns are as long as `times_s`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Samples {
    /// Number of the first sample of this batch in the whole run.
    pub first_index: u64,
    /// When, s, as exact as f64 is.
    pub times_s: Vec<f64>,
    /// When, in whole ns: what recordings stamp.
    pub stamps_ns: Vec<i64>,
    /// In the order of the plan's bodies.
    pub bodies: Vec<BodySamples>,
}

/// What one body's channels read, each channel its width of columns.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BodySamples {
    channels: Vec<(Channel, usize)>,
    columns: Vec<Vec<f64>>,
}

impl Samples {
    /// How many samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.times_s.len()
    }

    /// Empties all columns, which stay as they are otherwise.
    pub fn clear(&mut self) {
        self.times_s.clear();
        self.stamps_ns.clear();
        self.bodies.iter_mut().flat_map(BodySamples::columns_mut).for_each(Vec::clear);
    }

    /// Adds the samples that follow, of the same bodies and channels. To what is empty, the first.
    pub fn append(&mut self, next: &Self) {
        if self.is_empty() {
            self.clone_from(next);
            return;
        }
        self.times_s.extend_from_slice(&next.times_s);
        self.stamps_ns.extend_from_slice(&next.stamps_ns);
        let columns = self.bodies.iter_mut().flat_map(BodySamples::columns_mut);
        for (column, next) in columns.zip(next.bodies.iter().flat_map(BodySamples::columns)) {
            column.extend_from_slice(next);
        }
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.times_s.is_empty()
    }
}

impl BodySamples {
    /// Empty columns for these channels.
    #[must_use]
    pub fn new(channels: &[Channel]) -> Self {
        let mut start = 0;
        let place = |channel: &Channel| {
            let first = start;
            start += channel.width();
            (*channel, first)
        };
        let channels: Vec<_> = channels.iter().map(place).collect();
        Self { channels, columns: vec![Vec::new(); start] }
    }

    /// The channels, in order.
    pub fn channels(&self) -> impl Iterator<Item = Channel> {
        self.channels.iter().map(|(channel, _)| *channel)
    }

    /// The columns of `channel`, or `None` if it is not watched.
    #[must_use]
    pub fn channel(&self, channel: Channel) -> Option<&[Vec<f64>]> {
        let (_, first) = self.channels.iter().find(|(candidate, _)| *candidate == channel)?;
        Some(&self.columns[*first..first + channel.width()])
    }

    /// The columns of `channel` to write to, or `None` if it is not watched.
    pub fn channel_mut(&mut self, channel: Channel) -> Option<&mut [Vec<f64>]> {
        let (_, first) = self.channels.iter().find(|(candidate, _)| *candidate == channel)?;
        Some(&mut self.columns[*first..first + channel.width()])
    }

    /// All columns in the order of the channels.
    #[must_use]
    pub fn columns(&self) -> &[Vec<f64>] {
        &self.columns
    }

    /// All columns to write to.
    pub fn columns_mut(&mut self) -> &mut [Vec<f64>] {
        &mut self.columns
    }
}
