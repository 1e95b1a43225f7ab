use super::CompareError;
use super::facts::{events, fact_differences};
use super::matching::{Matched, matched};
use super::pairing::{Cursor, Feed, Follower, Pairs, Resampler, Scene, Way, Window};
use super::report::{Coverage, Difference, Report, SideReport};
use super::side::Side;
use super::tolerance::Tolerances;
use super::work::Work;
use crate::recording::Poses;
use crate::scenario::{Plan, PlannedBody};
use crate::telemetry::Channel;

/// How two motions are to be compared.
///
/// ```no_run
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use polhode::comparison::{Comparison, Side};
///
/// let (a, b) = (Side::open("before.mcap".as_ref())?, Side::open("after.rrd".as_ref())?);
/// let report = Comparison::default().run(a, b)?;
/// println!("{}", report.verdict());
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Comparison {
    /// What counts as the same.
    pub tolerances: Tolerances,
    /// What is compared; empty: every channel.
    pub channels: Vec<Channel>,
    /// Bodies of the first side that are called otherwise on the second, with that name. Others are those of equal name;
    /// where this is empty and each side has one body, it is that.
    pub names: Vec<(String, String)>,
    /// By how much the clock of the second side is put forward, s.
    pub shift_s: f64,
    /// Whether the second of two recordings is interpolated at the times of the first.
    pub is_resampled: bool,
    /// Where to begin, s of the first side's clock.
    pub from_s: Option<f64>,
    /// Where to end, s of the first side's clock.
    pub to_s: Option<f64>,
}

impl Comparison {
    /// Compares `a` with `b`, sample by sample at the times that they share: memory is flat at any length. A scene is
    /// computed at the other side's times and with its channels; of two scenes, the second at those of the first.
    ///
    /// # Errors
    /// If a side cannot be read or run, has no sample in the window, or the two have no times or channels in common.
    pub fn run(&self, a: Side, b: Side) -> Result<Report, CompareError> {
        self.compare(a, b, None)
    }

    /// The same, and where each body that both have is on either side, in the report's order, as far as attitudes tell.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn run_with_poses(&self, a: Side, b: Side) -> Result<(Report, Vec<Poses>), CompareError> {
        let mut poses = Vec::new();
        let report = self.compare(a, b, Some(&mut poses))?;
        Ok((report, poses))
    }

    fn compare(&self, a: Side, b: Side, poses: Option<&mut Vec<Poses>>) -> Result<Report, CompareError> {
        let headings = [a.heading(), b.heading()];
        let names = [a.name().to_owned(), b.name().to_owned()];
        let is_scene = [&a, &b].map(|side| matches!(side, Side::Scene(_)));
        let matching = matched(self, &headings, &names, is_scene)?;
        let events = events(&headings, [&a, &b], &matching.bodies);
        let mut work = Work::new(matching.bodies, &self.tolerances, poses);
        let mut pairs = Pairs::new(self.way(a, b, &work.bodies)?);
        while let Some(stretch) = pairs.next()? {
            work.include(&stretch);
        }
        let coverage = pairs.coverage();
        self.refuse_what_does_not_meet(&names, coverage, pairs.tally.common)?;
        let mut differences = matching.differences;
        differences.extend(self.time_differences(coverage, pairs.tally.only));
        let side = |side: usize| SideReport {
            name: names[side].clone(),
            is_scene: is_scene[side],
            has_provenance: !headings[side].provenance.is_empty(),
            coverage: coverage[side],
            alone: pairs.tally.only[side],
        };
        Ok(Report {
            sides: [side(0), side(1)],
            common: pairs.tally.common,
            times_apart_s: pairs.tally.apart_s,
            bodies: work.finish(&self.tolerances, &pairs),
            differences,
            events,
            facts: fact_differences(&headings, is_scene),
        })
    }

    fn window(&self) -> Window {
        Window { from_s: self.from_s.unwrap_or(f64::NEG_INFINITY), to_s: self.to_s.unwrap_or(f64::INFINITY) }
    }

    fn way<'a>(&self, a: Side<'a>, b: Side<'a>, bodies: &[Matched]) -> Result<Way<'a>, CompareError> {
        let cursor = |feed, side: usize| Cursor::new(feed, self.window(), if side == 1 { self.shift_s } else { 0.0 });
        let scene = |plan, side: usize| -> Result<Scene<'a>, CompareError> {
            let shift_s = if side == 1 { self.shift_s } else { 0.0 };
            Ok(Scene { plan, follower: Follower::new(&following(plan, bodies, side))?, side, shift_s })
        };
        Ok(match (a, b) {
            (Side::Recording { recording: a, .. }, Side::Recording { recording: b, .. }) if self.is_resampled => {
                let count = b.heading().bodies.len();
                let b = Resampler::new(cursor(Feed::Recording(*b), 1), bodies, count);
                Way::Resampled { a: cursor(Feed::Recording(*a), 0), b }
            }
            (Side::Recording { recording: a, .. }, Side::Recording { recording: b, .. }) => {
                Way::Merged { a: cursor(Feed::Recording(*a), 0), b: cursor(Feed::Recording(*b), 1) }
            }
            (Side::Recording { recording, .. }, Side::Scene(plan)) => {
                Way::Followed { leader: cursor(Feed::Recording(*recording), 0), scene: scene(plan, 1)? }
            }
            (Side::Scene(plan), Side::Recording { recording, .. }) => {
                Way::Followed { leader: cursor(Feed::Recording(*recording), 1), scene: scene(plan, 0)? }
            }
            (Side::Scene(led), Side::Scene(plan)) => {
                Way::Followed { leader: cursor(Feed::Run(led.start()?), 0), scene: scene(plan, 1)? }
            }
        })
    }

    fn refuse_what_does_not_meet(
        &self,
        names: &[String; 2],
        coverage: [Coverage; 2],
        common: Coverage,
    ) -> Result<(), CompareError> {
        for (name, coverage) in names.iter().zip(coverage) {
            if coverage.samples == 0 && common.samples == 0 {
                let window = match (self.from_s, self.to_s) {
                    (None, None) => String::new(),
                    (Some(from), None) => format!(" from {from} s on"),
                    (None, Some(to)) => format!(" up to {to} s"),
                    (Some(from), Some(to)) => format!(" from {from} to {to} s"),
                };
                return Err(CompareError::Empty { side: name.clone(), window });
            }
        }
        // A start that they share says nothing of the rest.
        let is_only_one = common.samples == 1 && coverage.iter().all(|coverage| coverage.samples > 1);
        if common.samples == 0 || is_only_one {
            let [a, b] = names.clone();
            return Err(CompareError::NoCommonTimes { a, b, common: common.samples, times: coverage });
        }
        Ok(())
    }

    /// Sides of other rates have times of their own; where one side has nothing at all, they differ.
    fn time_differences(&self, [a, b]: [Coverage; 2], only: [Coverage; 2]) -> Vec<Difference> {
        let interval_s = 1.5 * a.interval_s.max(b.interval_s);
        let is_apart = |a: f64, b: f64| (a - b).abs() > interval_s;
        if is_apart(a.from_s, b.from_s) || is_apart(a.to_s, b.to_s) {
            return vec![Difference::Span];
        }
        let counts = |side: &usize| self.tolerances.are_exact() && only[*side].samples > 0;
        (0..2).filter(counts).map(|side| Difference::Times { side }).collect()
    }
}

/// The bodies of a scene in their order, and their points, with the channels that are compared.
fn following(plan: &Plan, bodies: &[Matched], side: usize) -> Vec<PlannedBody> {
    let compared = |number: usize| {
        let matched = bodies.iter().find(|matched| matched.numbers[side] == number);
        matched.map(|matched| matched.channels.clone()).unwrap_or_default()
    };
    // Points are numbered after all bodies.
    let mut point = plan.bodies.len();
    let followed = |(number, body): (usize, &PlannedBody)| {
        let mut body = body.clone();
        for known in &mut body.points {
            known.channels = compared(point);
            point += 1;
        }
        body.watching(&compared(number))
    };
    plan.bodies.iter().enumerate().map(followed).collect()
}
