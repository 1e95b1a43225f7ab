use super::matching::Matched;
use super::measure::{Growth, Measure};
use super::pairing::{Pairs, Stretch};
use super::report::{BodyReport, ChannelReport};
use super::tolerance::{Rule, Tolerances};
use crate::recording::{Pose, Poses};
use crate::telemetry::{Channel, Samples};

/// What is compared, and what was found so far.
pub(super) struct Work<'p> {
    pub bodies: Vec<Matched>,
    measures: Vec<Vec<Measure>>,
    /// Where bodies are, if that is wanted.
    poses: Option<&'p mut Vec<Poses>>,
}

impl<'p> Work<'p> {
    pub fn new(bodies: Vec<Matched>, tolerances: &Tolerances, mut poses: Option<&'p mut Vec<Poses>>) -> Self {
        let new = |matched: &Matched| {
            matched.channels.iter().map(|channel| Measure::new(*channel, tolerances.of(*channel))).collect()
        };
        let measures = bodies.iter().map(new).collect();
        if let Some(poses) = &mut poses {
            poses.resize(bodies.len(), Poses::default());
        }
        Self { bodies, measures, poses }
    }

    pub fn include(&mut self, stretch: &Stretch) {
        for (matched, measures) in self.bodies.iter().zip(&mut self.measures) {
            for (channel, measure) in matched.channels.iter().zip(measures) {
                let columns = |side: usize| {
                    let (samples, range): &(&Samples, _) = &stretch.sides[side];
                    let columns = samples.bodies[matched.numbers[side]].channel(*channel).unwrap_or_default();
                    columns.iter().map(|column| &column[range.clone()]).collect::<Vec<_>>()
                };
                measure.include(stretch.times_s, &columns(0), &columns(1));
            }
        }
        for (body, poses) in self.bodies.iter().zip(self.poses.iter_mut().flat_map(|poses| poses.iter_mut())) {
            pose(body, stretch, poses);
        }
    }

    pub fn finish(self, tolerances: &Tolerances, pairs: &Pairs) -> Vec<BodyReport> {
        let body = |(matched, measures): (Matched, Vec<Measure>)| {
            let channels = matched.channels.iter().zip(measures).enumerate();
            let channels = channels.map(|(number, (channel, measure))| {
                let interpolation = pairs.interpolation(matched.numbers[1], number);
                finished(*channel, tolerances.of(*channel), measure, interpolation)
            });
            BodyReport { names: matched.names, channels: channels.collect() }
        };
        self.bodies.into_iter().zip(self.measures).map(body).collect()
    }
}

fn finished(channel: Channel, rule: Rule, measure: Measure, interpolation: Option<f64>) -> ChannelReport {
    let limit = match rule {
        Rule::Within(tolerance) => Some(tolerance.limit(measure.size)),
        Rule::Exact | Rule::Shown => None,
    };
    let first_out_s = match rule {
        Rule::Within(_) => limit.and_then(|limit| measure.exceeding.first(limit + interpolation.unwrap_or(0.0))),
        Rule::Exact => measure.bits.first.map(|first| first.time_s),
        Rule::Shown => None,
    };
    let ceiling = match channel {
        Channel::Attitude => std::f64::consts::PI,
        angles if angles.comes_round() => std::f64::consts::PI,
        // They are differences themselves, and have no size to grow to.
        Channel::EnergyDrift | Channel::MomentumDrift | Channel::Slip => f64::INFINITY,
        _ => measure.size,
    };
    ChannelReport {
        channel,
        rule,
        samples: measure.samples,
        size: measure.size,
        limit,
        interpolation,
        worst: measure.worst,
        rms: measure.rms(),
        first_out_s,
        bits: measure.bits,
        growth: Growth::of(&measure.trace, ceiling),
        trace: measure.trace,
    }
}

/// Adds where a body is, if both sides know its attitude.
fn pose(body: &Matched, stretch: &Stretch, poses: &mut Poses) {
    let [a, b] = [0, 1].map(|side| {
        let (samples, range) = &stretch.sides[side];
        let samples = &samples.bodies[body.numbers[side]];
        let attitude = samples.channel(Channel::Attitude)?;
        let position = samples.channel(Channel::Position);
        Some(move |index: usize| Pose {
            attitude: std::array::from_fn(|k| attitude[k][range.start + index]),
            position: position.map(|columns| std::array::from_fn(|k| columns[k][range.start + index])),
        })
    });
    if let (Some(a), Some(b)) = (a, b) {
        for (index, time_s) in stretch.times_s.iter().enumerate() {
            poses.push(*time_s, [a(index), b(index)]);
        }
    }
}
