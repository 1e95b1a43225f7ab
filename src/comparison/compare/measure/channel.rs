use super::bits::Bits;
use super::distance::{component, distance, nearest, size};
use super::trace::Trace;
use crate::comparison::compare::tolerance::Rule;
use crate::telemetry::Channel;

/// The largest difference of a channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// In the channel's unit; of an attitude, rad; infinite where a value is not finite.
    pub difference: f64,
    /// When, s.
    pub time_s: f64,
    /// In which component most, if it has several and is no attitude.
    pub component: Option<usize>,
}

/// What is known of the differences of one channel so far.
#[derive(Debug)]
pub(in crate::comparison) struct Measure {
    channel: Channel,
    pub samples: u64,
    pub size: f64,
    pub worst: Option<Worst>,
    pub bits: Bits,
    pub trace: Trace,
    pub exceeding: Exceeding,
    squares: f64,
}

impl Measure {
    pub fn new(channel: Channel, rule: Rule) -> Self {
        Self {
            channel,
            samples: 0,
            size: 0.0,
            worst: None,
            bits: Bits::default(),
            trace: Trace::default(),
            exceeding: Exceeding::new(rule),
            squares: 0.0,
        }
    }

    /// Compares the columns of the one side with those of the other, at `times_s`; all are equally long.
    pub fn include(&mut self, times_s: &[f64], a: &[&[f64]], b: &[&[f64]]) {
        match a.len() {
            4 => self.include_values::<4>(times_s, a, b),
            3 => self.include_values::<3>(times_s, a, b),
            _ => self.include_values::<1>(times_s, a, b),
        }
        self.samples += times_s.len() as u64;
    }

    fn include_values<const N: usize>(&mut self, times_s: &[f64], a: &[&[f64]], b: &[&[f64]]) {
        let at = |columns: &[&[f64]], index: usize| -> [f64; N] { std::array::from_fn(|k| columns[k][index]) };
        // The same bits are the usual case and cost next to nothing.
        if a.iter().zip(b).all(|(a, b)| has_same_bits(a, b)) {
            for (index, time_s) in times_s.iter().enumerate() {
                self.see_size(size(at(a, index)));
                self.trace.push(*time_s, 0.0);
            }
            return;
        }
        for (index, time_s) in times_s.iter().enumerate() {
            let (a, b) = (at(a, index), at(b, index));
            if a.map(f64::to_bits) == b.map(f64::to_bits) {
                self.see_size(size(a));
                self.trace.push(*time_s, 0.0);
                continue;
            }
            self.bits.include(*time_s, a, b);
            let b = nearest(self.channel, a, b);
            let found = distance(a, b);
            self.see_size(found.size);
            self.include_difference(*time_s, found.between, || component(a, b));
        }
    }

    /// What is not finite is no size that a tolerance could be a share of.
    fn see_size(&mut self, size: f64) {
        if size > self.size && size.is_finite() {
            self.size = size;
        }
    }

    fn include_difference(&mut self, time_s: f64, difference: f64, component: impl Fn() -> Option<usize>) {
        self.squares += difference * difference;
        self.trace.push(time_s, difference);
        if self.worst.is_none_or(|worst| difference > worst.difference) {
            self.worst = Some(Worst { difference, time_s, component: component() });
            self.exceeding.rise(time_s, difference, self.size);
        }
    }

    /// Root of the mean square of the differences.
    #[expect(clippy::cast_precision_loss, reason = "a mean for people")]
    pub fn rms(&self) -> f64 {
        (self.squares / self.samples.max(1) as f64).sqrt()
    }
}

fn has_same_bits(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

/// When differences first exceed a limit that is known at the end only, as it depends on the largest size. The first
/// difference beyond a limit is larger than all before it, so it is enough to keep those that are, and of these only
/// ones that are larger by a thousandth: the time found is exact if the size was settled by then, and else that of a
/// difference at most a thousandth beyond the limit.
#[derive(Debug)]
pub(in crate::comparison) struct Exceeding {
    rule: Rule,
    /// Time and difference, both ascending.
    rises: Vec<(f64, f64)>,
}

impl Exceeding {
    /// Rises are kept where they are apart by this.
    const APART: f64 = 1.0 + 1.0 / 1024.0;
    /// Rises that are looked through for those which the limit has overtaken.
    const MANY: usize = 1024;

    fn new(rule: Rule) -> Self {
        Self { rule, rises: Vec::new() }
    }

    fn rise(&mut self, time_s: f64, difference: f64, size: f64) {
        let Rule::Within(tolerance) = self.rule else { return };
        let limit = tolerance.limit(size);
        if difference <= limit || self.rises.last().is_some_and(|(_, last)| difference <= last * Self::APART) {
            return;
        }
        if self.rises.len().is_multiple_of(Self::MANY) {
            self.rises.retain(|(_, rise)| *rise > limit);
        }
        self.rises.push((time_s, difference));
    }

    /// When, s, if ever.
    pub fn first(&self, limit: f64) -> Option<f64> {
        self.rises.iter().find(|(_, difference)| *difference > limit).map(|(time_s, _)| *time_s)
    }
}
