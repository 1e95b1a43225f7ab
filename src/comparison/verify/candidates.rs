use super::kinematics::Turns;
use super::series::Series;
use super::{Reading, clock};
use crate::recording::{Axes, Observed};

/// What the file's columns may mean, each with how badly its attitudes turn as its ω says; the best first.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidates {
    /// Readings and mismatches, relative: root mean square of the difference of turns over that of the turns.
    pub all: Vec<(Reading, f64)>,
    /// The reading taken.
    pub chosen: Reading,
    /// Whether the motion tells the frame of ω: a spin about a fixed axis does not, nor do samples too far apart.
    pub is_decided: bool,
    /// Readings that fit as well as the one taken.
    pub as_good: Vec<Reading>,
}

/// Samples looked at: the readings differ by far more than rounding.
const MOST_SAMPLES: usize = 3000;
/// A reading fits worse if its mismatch is this many times that of the best, and a share of a turn that no lag of half a
/// step makes.
const WORSE: f64 = 3.0;
/// What sampling and the methods of engines leave of a right reading, relative.
pub(super) const RIGHT: f64 = 0.02;
/// Fewer samples to a turn do not tell.
pub const FEWEST_PER_TURN: f64 = 8.0;

impl Candidates {
    /// Of a file; a reading that needs what is not there is left out. `None` where none can be read.
    pub(super) fn of(observed: &Observed, used: &[usize]) -> Option<Self> {
        let told = observed.angular_velocity.as_ref().and_then(|track| track.axes);
        let plain = Reading::plain(told.unwrap_or(Axes::Body));
        let only = |chosen| Self { all: Vec::new(), chosen, is_decided: false, as_good: Vec::new() };
        if observed.attitude.is_none() || observed.angular_velocity.is_none() {
            Series::read(observed, used, &plain)?;
            return Some(only(plain));
        }
        let used = &used[..used.len().min(MOST_SAMPLES)];
        let mut all: Vec<(Reading, f64)> = Vec::new();
        for reading in readings(plain.axes) {
            let Some(series) = Series::read(observed, used, &reading) else { continue };
            for factor in factors(&series) {
                let reading = Reading { rate_factor: reading.rate_factor * factor, ..reading };
                let Some(series) = Series::read(observed, used, &reading) else { continue };
                let half =
                    0.5 * clock::median(&mut series.times.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>());
                // Engines keep q and ω up to half a step apart; that is no other frame.
                let mismatches = [0.0, half, -half].map(|lag| Turns::of(&series, lag).mismatch());
                let mismatch = mismatches.into_iter().fold(f64::INFINITY, f64::min);
                if mismatch.is_finite() && series.samples_per_turn() >= FEWEST_PER_TURN {
                    all.push((reading, mismatch));
                }
            }
        }
        if all.is_empty() {
            Series::read(observed, used, &plain)?;
            return Some(only(plain));
        }
        // A stable sort: of what fits alike, what is plainer stays first.
        all.sort_by(|one, other| one.1.total_cmp(&other.1));
        let best = all[0].1;
        let fits = |mismatch: f64| mismatch <= WORSE * best || mismatch < RIGHT;
        let order = |reading: &Reading| readings(plain.axes).iter().position(|known| same_but_factor(known, reading));
        let mut fitting: Vec<Reading> =
            all.iter().filter(|(_, mismatch)| fits(*mismatch)).map(|(reading, _)| *reading).collect();
        fitting.sort_by_key(|reading| (reading.rate_factor != 1.0, order(reading)));
        // Where rounding decides nothing but the best is clearly better, it is the best that is meant.
        let clear = all.get(1).is_none_or(|(_, next)| *next > WORSE * best.max(1e-9));
        let chosen = if clear { all[0].0 } else { fitting.first().copied().unwrap_or(plain) };
        let as_good: Vec<Reading> =
            if clear { Vec::new() } else { fitting.into_iter().filter(|reading| *reading != chosen).collect() };
        let is_decided = as_good.iter().all(|reading| reading.axes == chosen.axes);
        Some(Self { all, chosen, is_decided, as_good })
    }

    /// The best reading that says something else of the frame or the quaternion, and how badly it fits.
    #[must_use]
    pub fn runner_up(&self) -> Option<&(Reading, f64)> {
        self.all.iter().find(|(reading, _)| !same_but_factor(reading, &self.chosen))
    }

    /// How badly the reading taken fits.
    #[must_use]
    pub fn mismatch(&self) -> Option<f64> {
        self.all.iter().find(|(reading, _)| *reading == self.chosen).map(|(_, mismatch)| *mismatch)
    }
}

fn same_but_factor(one: &Reading, other: &Reading) -> bool {
    one.scalar_last == other.scalar_last && one.body_from_world == other.body_from_world && one.axes == other.axes
}

/// The plain ones first, those in the axes that the file tells before the others.
fn readings(told: Axes) -> Vec<Reading> {
    let other = if told == Axes::Body { Axes::World } else { Axes::Body };
    let mut all = Vec::new();
    for scalar_last in [false, true] {
        for body_from_world in [false, true] {
            for axes in [told, other] {
                all.push(Reading { scalar_last, body_from_world, axes, rate_factor: 1.0 });
            }
        }
    }
    all
}

/// What ω may have to be multiplied by: 1, degrees, or what the angles between attitudes say.
fn factors(series: &Series) -> Vec<f64> {
    let turns: Vec<f64> =
        series.attitude.windows(2).map(|pair| super::rotation::log(&(pair[0].inverse() * pair[1])).norm()).collect();
    let mut ratios: Vec<f64> = turns
        .iter()
        .enumerate()
        .map(|(k, turn)| {
            turn / (0.5 * (series.omega[k] + series.omega[k + 1]).norm() * (series.times[k + 1] - series.times[k]))
        })
        .filter(|ratio| ratio.is_finite())
        .collect();
    let ratio = clock::median(&mut ratios);
    let mut factors = vec![1.0];
    let near = |other: f64| (ratio / other - 1.0).abs() < FACTOR;
    if near(Reading::DEGREES) {
        factors.push(Reading::DEGREES);
    } else if ratio > 0.0 && !near(1.0) {
        factors.push(ratio);
    }
    factors
}

/// A factor nearer to 1 than this is no other unit; it is found as an excess.
const FACTOR: f64 = 0.1;
