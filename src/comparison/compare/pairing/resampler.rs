use super::cursor::Cursor;
use super::interpolation::{Cubic, NODES, attitude, hermite};
use crate::comparison::compare::CompareError;
use crate::comparison::compare::matching::Matched;
use crate::comparison::compare::measure::distance::{distance, nearest};
use crate::telemetry::{BodySamples, Channel, Samples};

/// A recording at times that it does not have: cubics between its samples, by ω between attitudes and by the velocity
/// between positions where they are recorded.
///
/// How far the cubics are off is measured on the recording itself: each sample is interpolated from those around it, without
/// it. These are twice as far apart, so that a cubic's error, of order 4, is sixteen times as large; an eighth of it is told,
/// as at the ends it is larger.
pub(in crate::comparison) struct Resampler<'a> {
    cursor: Cursor<'a>,
    /// Samples around the time where it is.
    known: Samples,
    has_ended: bool,
    samples: Samples,
    /// What is interpolated of each body, with the largest error found.
    bodies: Vec<(Vec<Channel>, Vec<f64>)>,
    /// Up to when the error was measured, s.
    measured_s: f64,
}

impl<'a> Resampler<'a> {
    /// Samples that are kept before the time where it is.
    const BEFORE: usize = 4;
    /// What is told of the error that was measured.
    const SHARE: f64 = 1.0 / 8.0;

    /// Of the side behind `cursor`, which has `bodies`.
    pub fn new(cursor: Cursor<'a>, matched: &[Matched], bodies: usize) -> Self {
        let channels = |number: usize| {
            let matched = matched.iter().find(|matched| matched.numbers[1] == number);
            matched.map(|matched| matched.channels.clone()).unwrap_or_default()
        };
        let channels: Vec<_> = (0..bodies).map(channels).collect();
        let samples = channels.iter().map(|channels| BodySamples::new(channels)).collect();
        let bodies = channels.into_iter().map(|channels| (channels.clone(), vec![0.0; channels.len()])).collect();
        Self {
            cursor,
            known: Samples::default(),
            has_ended: false,
            samples: Samples { bodies: samples, ..Samples::default() },
            bodies,
            measured_s: f64::NEG_INFINITY,
        }
    }

    /// Interpolates at the first of `times_s`, as many as are within what it has in memory: from which to which.
    /// Those before are before its first sample; if none is left, those after are after its last.
    pub fn fill(&mut self, times_s: &[f64]) -> Result<(usize, usize), CompareError> {
        loop {
            self.forget(times_s[0]);
            let known = &self.known.times_s;
            let before = known.first().map_or(0, |first| times_s.partition_point(|time_s| time_s < first));
            // Two samples behind each time, but at the end.
            let last = if self.has_ended { known.last() } else { known.len().checked_sub(3).map(|at| &known[at]) };
            let until = last.map_or(0, |last| times_s.partition_point(|time_s| time_s <= last)).max(before);
            if until > before || self.has_ended || before == times_s.len() {
                self.measure();
                self.interpolate(&times_s[before..until]);
                return Ok((before, until));
            }
            self.learn()?;
        }
    }

    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    pub fn cursor(&self) -> &Cursor<'a> {
        &self.cursor
    }

    /// Reads what is left, to know how much there was.
    pub fn drain(&mut self) -> Result<(), CompareError> {
        while self.cursor.refill()? {
            self.cursor.advance(usize::MAX);
        }
        Ok(())
    }

    /// Of each body and channel, in the channel's unit.
    pub fn error(&self, body: usize, channel: usize) -> f64 {
        Self::SHARE * self.bodies.get(body).and_then(|(_, errors)| errors.get(channel)).copied().unwrap_or(0.0)
    }

    /// Drops what is long past.
    fn forget(&mut self, time_s: f64) {
        let past = self.known.times_s.partition_point(|known| *known < time_s).saturating_sub(Self::BEFORE);
        // Seldom, as the rest is moved.
        if past > self.known.len() / 2 {
            self.known.times_s.drain(..past);
            let columns = self.known.bodies.iter_mut().flat_map(BodySamples::columns_mut);
            columns.for_each(|column| drop(column.drain(..past)));
        }
    }

    fn learn(&mut self) -> Result<(), CompareError> {
        if !self.cursor.refill()? {
            self.has_ended = true;
            return Ok(());
        }
        let (batch, at) = self.cursor.samples();
        let range = at..at + self.cursor.times_s().len();
        if self.known.bodies.is_empty() {
            self.known.bodies.clone_from(&batch.bodies);
            self.known.bodies.iter_mut().flat_map(BodySamples::columns_mut).for_each(Vec::clear);
        }
        self.known.times_s.extend_from_slice(&batch.times_s[range.clone()]);
        let known = self.known.bodies.iter_mut().flat_map(BodySamples::columns_mut);
        for (known, column) in known.zip(batch.bodies.iter().flat_map(BodySamples::columns)) {
            known.extend_from_slice(&column[range.clone()]);
        }
        self.cursor.advance(range.len());
        Ok(())
    }

    fn interpolate(&mut self, times_s: &[f64]) {
        self.samples.clear();
        self.samples.times_s.extend_from_slice(times_s);
        for time_s in times_s {
            let after = self.known.times_s.partition_point(|known| known <= time_s);
            let first = after.saturating_sub(2).min(self.known.len().saturating_sub(NODES));
            let count = NODES.min(self.known.len());
            let nodes: [usize; NODES] = std::array::from_fn(|k| first + k.min(count - 1));
            let from = after.saturating_sub(1).min(self.known.len().saturating_sub(2));
            let ends = [from, (from + 1).min(self.known.len() - 1)];
            for ((channels, _), (known, samples)) in
                self.bodies.iter().zip(self.known.bodies.iter().zip(&mut self.samples.bodies))
            {
                let at = Around { times_s: &self.known.times_s, nodes: &nodes[..count], ends, body: known };
                for channel in channels {
                    let columns = samples.channel_mut(*channel).unwrap_or_default();
                    match channel.width() {
                        4 => push(columns, at.value::<4>(*channel, *time_s)),
                        3 => push(columns, at.value::<3>(*channel, *time_s)),
                        _ => push(columns, at.value::<1>(*channel, *time_s)),
                    }
                }
            }
        }
    }

    /// Interpolates samples from those around them.
    fn measure(&mut self) {
        let times_s = &self.known.times_s;
        let from = times_s.partition_point(|time_s| *time_s <= self.measured_s).max(3);
        let until = times_s.len().saturating_sub(3);
        for k in from..until {
            let nodes = [k - 3, k - 1, k + 1, k + 3];
            for ((channels, errors), body) in self.bodies.iter_mut().zip(&self.known.bodies) {
                let at = Around { times_s, nodes: &nodes, ends: [k - 1, k + 1], body };
                for (channel, error) in channels.iter().zip(errors) {
                    let found = match channel.width() {
                        4 => at.miss::<4>(*channel, k),
                        3 => at.miss::<3>(*channel, k),
                        _ => at.miss::<1>(*channel, k),
                    };
                    *error = error.max(found);
                }
            }
        }
        if until > from {
            self.measured_s = times_s[until - 1];
        }
    }
}

fn push<const N: usize>(columns: &mut [Vec<f64>], value: [f64; N]) {
    columns.iter_mut().zip(value).for_each(|(column, value)| column.push(value));
}

/// The samples of one body around a time.
struct Around<'s> {
    times_s: &'s [f64],
    nodes: &'s [usize],
    ends: [usize; 2],
    body: &'s BodySamples,
}

impl Around<'_> {
    fn row<const N: usize>(&self, channel: Channel, index: usize) -> [f64; N] {
        let columns = self.body.channel(channel).unwrap_or_default();
        std::array::from_fn(|k| columns.get(k).and_then(|column| column.get(index)).copied().unwrap_or(f64::NAN))
    }

    fn value<const N: usize>(&self, channel: Channel, time_s: f64) -> [f64; N] {
        let times_s = self.ends.map(|end| self.times_s[end]);
        let is_between = times_s[1] > times_s[0];
        if channel == Channel::Attitude && is_between && self.body.channel(Channel::AngularVelocity).is_some() {
            let q = self.ends.map(|end| self.row(channel, end));
            let omega = self.ends.map(|end| self.row(Channel::AngularVelocity, end));
            let value = attitude(times_s, q, omega, time_s);
            return std::array::from_fn(|k| value[k]);
        }
        if channel == Channel::Position && is_between && self.body.channel(Channel::Velocity).is_some() {
            let rates = self.ends.map(|end| self.row(Channel::Velocity, end));
            return hermite(times_s, self.ends.map(|end| self.row(channel, end)), rates, time_s);
        }
        let mut nodes = [0.0; NODES];
        let mut values = [[0.0; N]; NODES];
        for (place, node) in self.nodes.iter().enumerate() {
            (nodes[place], values[place]) = (self.times_s[*node], self.row(channel, *node));
        }
        let count = self.nodes.len();
        Cubic::new(&nodes[..count], time_s).value(channel, &values[..count])
    }

    /// How far what is interpolated at sample `index` is from it.
    fn miss<const N: usize>(&self, channel: Channel, index: usize) -> f64 {
        let row = self.row(channel, index);
        distance(nearest(channel, row, self.value::<N>(channel, self.times_s[index])), row).between
    }
}
