use std::ops::Range;

use super::cursor::Cursor;
use super::follower::Follower;
use super::resampler::Resampler;
use crate::comparison::compare::CompareError;
use crate::comparison::compare::report::Coverage;
use crate::scenario::{Plan, nanoseconds};
use crate::telemetry::Samples;

/// Samples of both sides at the same times, stretch by stretch.
pub(in crate::comparison) struct Pairs<'a> {
    way: Way<'a>,
    pub tally: Tally,
}

/// How the second of a pair is found.
pub(in crate::comparison) enum Way<'a> {
    /// Both sides have times of their own.
    Merged { a: Cursor<'a>, b: Cursor<'a> },
    /// One side is computed at the times of the other.
    Followed { leader: Cursor<'a>, scene: Scene<'a> },
    /// The second is interpolated at the times of the first.
    Resampled { a: Cursor<'a>, b: Resampler<'a> },
}

/// The side that is computed.
pub(in crate::comparison) struct Scene<'a> {
    pub plan: &'a Plan,
    pub follower: Follower,
    /// Which side it is: 0 or 1.
    pub side: usize,
    /// By how much its clock is put forward, s.
    pub shift_s: f64,
}

/// How many times there are, and where.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::comparison) struct Tally {
    pub common: Coverage,
    pub only: [Coverage; 2],
    /// The largest difference between times that count as one, s.
    pub apart_s: f64,
}

/// A stretch of samples at the same times.
pub(in crate::comparison) struct Stretch<'p> {
    pub times_s: &'p [f64],
    pub sides: [(&'p Samples, Range<usize>); 2],
}

impl<'a> Pairs<'a> {
    pub fn new(way: Way<'a>) -> Self {
        Self { way, tally: Tally::default() }
    }

    /// The next stretch, at least one sample long; `None` at the end of both sides.
    pub fn next(&mut self) -> Result<Option<Stretch<'_>>, CompareError> {
        match &mut self.way {
            Way::Merged { a, b } => merge(a, b, &mut self.tally),
            Way::Followed { leader, scene } => follow(leader, scene, &mut self.tally),
            Way::Resampled { a, b } => resample(a, b, &mut self.tally),
        }
    }

    /// Where the samples of each side are, once all are read.
    pub fn coverage(&self) -> [Coverage; 2] {
        match &self.way {
            Way::Merged { a, b } => [a.coverage(), b.coverage()],
            Way::Resampled { a, b } => [a.coverage(), b.cursor().coverage()],
            Way::Followed { leader, scene } => {
                let mut sides = [leader.coverage(); 2];
                sides[scene.side] = scene.coverage(leader, &self.tally);
                sides
            }
        }
    }
}

impl Pairs<'_> {
    /// How far a channel of a body may be off where it was interpolated; bodies are those of the second side.
    pub fn interpolation(&self, body: usize, channel: usize) -> Option<f64> {
        match &self.way {
            Way::Resampled { b, .. } => Some(b.error(body, channel)),
            _ => None,
        }
    }
}

fn merge<'p>(a: &'p mut Cursor, b: &'p mut Cursor, tally: &mut Tally) -> Result<Option<Stretch<'p>>, CompareError> {
    loop {
        match (a.refill()?, b.refill()?) {
            (true, true) => {}
            (false, false) => return Ok(None),
            (true, false) => {
                pass(a, a.times_s().len(), &mut tally.only[0]);
                continue;
            }
            (false, true) => {
                pass(b, b.times_s().len(), &mut tally.only[1]);
                continue;
            }
        }
        let common = common(a.times_s(), b.times_s(), tally);
        if common > 0 {
            let (from, to) = (a.samples().1, b.samples().1);
            a.advance(common);
            b.advance(common);
            let sides = [(a.samples().0, from..from + common), (b.samples().0, to..to + common)];
            return Ok(Some(Stretch { times_s: &sides[0].0.times_s[from..from + common], sides }));
        }
        // Whichever is earlier has nobody beside it.
        let (first_a, first_b) = (a.times_s()[0], b.times_s()[0]);
        if first_a < first_b {
            let lone = a.times_s().partition_point(|time_s| *time_s < first_b && !is_same(*time_s, first_b));
            pass(a, lone.max(1), &mut tally.only[0]);
        } else {
            let lone = b.times_s().partition_point(|time_s| *time_s < first_a && !is_same(*time_s, first_a));
            pass(b, lone.max(1), &mut tally.only[1]);
        }
    }
}

fn pass(cursor: &mut Cursor, count: usize, lone: &mut Coverage) {
    lone.include(&cursor.times_s()[..count]);
    cursor.advance(count);
}

/// How many of the times to come are the same.
fn common(a: &[f64], b: &[f64], tally: &mut Tally) -> usize {
    let count = a.iter().zip(b).take_while(|(a, b)| is_same(**a, **b)).count();
    tally.common.include(&a[..count]);
    tally.apart_s = a[..count].iter().zip(b).map(|(a, b)| (a - b).abs()).fold(tally.apart_s, f64::max);
    count
}

/// Whether two times, s, are in the same ns.
fn is_same(a: f64, b: f64) -> bool {
    a == b || nanoseconds(a) == nanoseconds(b)
}

fn follow<'p>(
    leader: &'p mut Cursor,
    scene: &'p mut Scene,
    tally: &mut Tally,
) -> Result<Option<Stretch<'p>>, CompareError> {
    while leader.refill()? {
        let times_s = leader.times_s();
        let own = |time_s: f64| time_s - scene.shift_s;
        // The ends to the ns, as the clock may be put forward.
        let before = times_s.partition_point(|time_s| nanoseconds(own(*time_s)) < 0);
        let last = nanoseconds(scene.plan.grid.end());
        let until = times_s.partition_point(|time_s| nanoseconds(own(*time_s)) <= last).max(before);
        let lone = &mut tally.only[1 - scene.side];
        lone.include(&times_s[..before]);
        lone.include(&times_s[until..]);
        tally.common.include(&times_s[before..until]);
        scene.follower.fill(times_s[before..until].iter().map(|time_s| own(*time_s).max(0.0)))?;
        let (start, count) = (leader.samples().1, times_s.len());
        leader.advance(count);
        if before == until {
            continue;
        }
        let range = start + before..start + until;
        let led = (leader.samples().0, range.clone());
        let following = (scene.follower.samples(), 0..until - before);
        let times_s = &led.0.times_s[range];
        let sides = if scene.side == 0 { [following, led] } else { [led, following] };
        return Ok(Some(Stretch { times_s, sides }));
    }
    Ok(None)
}

fn resample<'p>(
    a: &'p mut Cursor,
    b: &'p mut Resampler,
    tally: &mut Tally,
) -> Result<Option<Stretch<'p>>, CompareError> {
    while a.refill()? {
        let times_s = a.times_s();
        let (before, until) = b.fill(times_s)?;
        // With nothing between, what is left is after the last.
        let done = if until > before { until } else { times_s.len() };
        let lone = &mut tally.only[0];
        lone.include(&times_s[..before]);
        lone.include(&times_s[until..done]);
        tally.common.include(&times_s[before..until]);
        let start = a.samples().1;
        a.advance(done);
        if until > before {
            let range = start + before..start + until;
            let sides = [(a.samples().0, range.clone()), (b.samples(), 0..until - before)];
            return Ok(Some(Stretch { times_s: &sides[0].0.times_s[range], sides }));
        }
    }
    b.drain()?;
    Ok(None)
}

impl Scene<'_> {
    /// It has a sample wherever it is asked for one, from its start to its end.
    fn coverage(&self, leader: &Cursor, tally: &Tally) -> Coverage {
        let window = leader.window();
        Coverage {
            samples: tally.common.samples,
            from_s: self.shift_s.max(window.from_s),
            to_s: (self.plan.grid.end() + self.shift_s).min(window.to_s),
            interval_s: leader.coverage().interval_s.max(self.plan.grid.mean_interval()),
        }
    }
}
