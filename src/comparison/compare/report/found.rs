use super::events::EventDifference;
use crate::comparison::compare::measure::Bits;
use crate::comparison::compare::measure::Growth;
use crate::comparison::compare::measure::Trace;
use crate::comparison::compare::measure::Worst;
use crate::comparison::compare::tolerance::Rule;
use crate::telemetry::Channel;

/// What comparing two motions has found.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The two sides.
    pub sides: [SideReport; 2],
    /// The times at which both have samples: what was compared.
    pub common: Coverage,
    /// The largest difference between two times that counted as one, as they are in the same ns, s.
    pub times_apart_s: f64,
    /// Of each body that both sides have, in the order of the first.
    pub bodies: Vec<BodyReport>,
    /// What makes them differ other than values.
    pub differences: Vec<Difference>,
    /// What happens at other times, of sides whose scenes are known and are not the same: what the scenes say, where the
    /// values say by how much the motion differs.
    pub events: Vec<EventDifference>,
    /// In what they say differently where they come from: no difference of the motion.
    pub facts: Vec<FactDifference>,
}

/// One side.
#[derive(Debug, Clone, PartialEq)]
pub struct SideReport {
    /// Path of the recording or name of the scene.
    pub name: String,
    /// Whether it is a scene, which was computed at the times of the other.
    pub is_scene: bool,
    /// Whether it says where it comes from.
    pub has_provenance: bool,
    /// Its samples within the window.
    pub coverage: Coverage,
    /// Those at times that the other side does not have.
    pub alone: Coverage,
}

/// When there are samples.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Coverage {
    /// How many.
    pub samples: u64,
    /// The first, s; 0 if there is none.
    pub from_s: f64,
    /// The last, s.
    pub to_s: f64,
    /// The mean interval between them, s; 0 of fewer than two.
    pub interval_s: f64,
}

/// What one body's channels are apart.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyReport {
    /// What it is called on each side.
    pub names: [String; 2],
    /// Of each channel that both have.
    pub channels: Vec<ChannelReport>,
}

/// How far the values of one channel are apart.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelReport {
    /// Which.
    pub channel: Channel,
    /// By what it is judged.
    pub rule: Rule,
    /// How many samples were compared.
    pub samples: u64,
    /// The largest value on either side, in the channel's unit (the norm of a vector); of an attitude 1.
    pub size: f64,
    /// How far apart values may be, in the channel's unit, rad between attitudes; `None` where that is not what is judged.
    pub limit: Option<f64>,
    /// How far interpolation is off, in the channel's unit, where one side was interpolated: an estimate. No less than this
    /// and the limit together is a difference.
    pub interpolation: Option<f64>,
    /// Where they are furthest apart; `None` if all bits are the same.
    pub worst: Option<Worst>,
    /// Root of the mean square of the differences.
    pub rms: f64,
    /// When the limit (with what interpolation may be off, or the first bit) is first left, s.
    pub first_out_s: Option<f64>,
    /// How the bits differ.
    pub bits: Bits,
    /// By which law the difference grows, if it can be told.
    pub growth: Option<Growth>,
    /// The difference over time.
    pub trace: Trace,
}

/// What comes of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Finding {
    /// Within the tolerance.
    Same,
    /// Out of tolerance by no more than interpolation may be off.
    Undecided,
    /// Out of tolerance.
    Different,
}

/// Something that only one side has, or has otherwise. Sides are 0 and 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Difference {
    /// A body that the other side lacks.
    Body {
        /// Who has it.
        side: usize,
        /// Its name.
        name: String,
    },
    /// A channel that the other side lacks.
    Channel {
        /// Who has it.
        side: usize,
        /// Of which body.
        body: String,
        /// Which.
        channel: Channel,
    },
    /// One side starts later or ends earlier.
    Span,
    /// Sample times that the other side lacks, where every bit counts.
    Times {
        /// Who has them.
        side: usize,
    },
}

/// A fact that both sides tell otherwise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FactDifference {
    /// Its name.
    pub name: String,
    /// What each side says; `None` where it says nothing of it.
    pub values: [Option<String>; 2],
}

impl BodyReport {
    /// Its name: that of the first side, unless only the second knows it.
    #[must_use]
    pub fn name(&self) -> &str {
        // What a `.csv` with a single body calls it.
        let [a, b] = &self.names;
        if a == "body" { b } else { a }
    }
}

impl Coverage {
    /// Goes on by these times, s, ascending.
    #[expect(clippy::cast_precision_loss, reason = "a mean")]
    pub(in crate::comparison) fn include(&mut self, times_s: &[f64]) {
        let (Some(first), Some(last)) = (times_s.first(), times_s.last()) else { return };
        if self.samples == 0 {
            self.from_s = *first;
        }
        self.to_s = *last;
        self.samples += times_s.len() as u64;
        self.interval_s = (self.to_s - self.from_s) / (self.samples - 1).max(1) as f64;
    }
}

impl ChannelReport {
    /// What is found of it.
    #[must_use]
    pub fn finding(&self) -> Finding {
        if self.first_out_s.is_some() {
            Finding::Different
        } else if self.limit.is_some_and(|limit| self.worst_difference() > limit) {
            Finding::Undecided
        } else {
            Finding::Same
        }
    }

    /// The worst difference.
    #[must_use]
    pub fn worst_difference(&self) -> f64 {
        self.worst.map_or(0.0, |worst| worst.difference)
    }

    /// The worst difference as a share of the channel's largest size; 0 where nothing differs.
    #[must_use]
    pub fn relative(&self) -> f64 {
        let worst = self.worst_difference();
        if worst == 0.0 { 0.0 } else { worst / self.size }
    }

    /// How near the worst difference is to its limit: above 1 it is out of tolerance. What is not judged is at 0, what is
    /// judged by bits at 0 or infinite.
    #[must_use]
    pub fn severity(&self) -> f64 {
        match (self.rule, self.limit) {
            (Rule::Shown, _) => 0.0,
            (Rule::Within(_), Some(limit)) if self.worst_difference() > 0.0 => self.worst_difference() / limit,
            _ if self.first_out_s.is_none() => 0.0,
            _ => f64::INFINITY,
        }
    }
}

impl Report {
    /// Whether this is the same motion, as far as was asked for.
    #[must_use]
    pub fn finding(&self) -> Finding {
        let of_channels = self.channels().map(|(_, channel)| channel.finding()).max().unwrap_or(Finding::Same);
        if self.differences.is_empty() { of_channels } else { Finding::Different }
    }

    /// Whether nothing that was asked for differs.
    #[must_use]
    pub fn is_same(&self) -> bool {
        self.finding() == Finding::Same
    }

    /// Whether all bits of what was compared are the same.
    #[must_use]
    pub fn is_same_to_the_bit(&self) -> bool {
        self.channels().all(|(_, channel)| channel.bits.differing == 0)
    }

    /// Every channel with its body.
    pub fn channels(&self) -> impl Iterator<Item = (&BodyReport, &ChannelReport)> {
        self.bodies.iter().flat_map(|body| body.channels.iter().map(move |channel| (body, channel)))
    }

    /// The channel that is furthest beyond, or nearest to, its limit; of several beyond it the one that left it first.
    #[must_use]
    pub fn worst(&self) -> Option<(&BodyReport, &ChannelReport)> {
        let judged = || self.channels().filter(|(_, channel)| channel.rule != Rule::Shown);
        let out = judged().filter_map(|found| Some((found.1.first_out_s?, found)));
        let first = out.min_by(|one, other| one.0.total_cmp(&other.0)).map(|(_, found)| found);
        // The first of those equally near, where max_by would take the last.
        let nearer = |one, other| if severity(&other) > severity(&one) { other } else { one };
        first.or_else(|| judged().reduce(nearer))
    }
}

fn severity((_, channel): &(&BodyReport, &ChannelReport)) -> f64 {
    channel.severity()
}
