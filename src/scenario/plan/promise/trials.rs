use super::nudge::nudged;
use super::search::Stepper;
use crate::dynamics::Problem;
use crate::propagation::{Effort, PropagationError, Propagator, States, Taylor, attitude_distance, attitude_distances};
use crate::scenario::Grid;

/// Steps of a trial at most; beyond, what was found is carried on to the end of the run.
const MOST_STEPS: u64 = 50_000;
/// Samples compared at most, as in certificates.
const MOST_SAMPLES: u64 = 1000;
/// As many parts, where the trial does not reach the end.
const PARTS: u32 = 1000;
/// Tolerance of a step at which steps are counted: their number hardly depends on it, their cost does.
const COUNTING: f64 = 1e-6;
/// How often the run is halved in search of a part that is short enough.
const HALVINGS: i32 = 60;
/// Patterns of roundings that are tried.
const PATTERNS: [u64; 3] = [0x5a5a_c3a5_9669_3c5a, 0x1234_5678_9abc_def0, 0xf0e1_d2c3_b4a5_9687];
/// A tape rounds the series of every step, and not its start alone: over a thousand steps of a motion that magnifies both,
/// this has moved it by 2.7 times as much.
const ROUNDED_SERIES: f64 = 4.0;
/// rad: a quaternion in f64 is no nearer.
const RESOLUTION: f64 = 5e-16;

/// A body's motion at full accuracy, for cheaper runs to be measured by.
pub struct Trials {
    problem: Problem,
    times: Vec<f64>,
    exact: States,
    /// How far roundings move the motion until each of the times, rad.
    floors: Vec<f64>,
    /// What errors are multiplied by to hold to the end of the run: the square of how much longer that is.
    pub growth: f64,
}

/// One run of a stepper.
#[derive(Debug, Clone, Copy)]
pub struct Trial {
    /// Largest attitude error, rad.
    pub error: f64,
    pub effort: Effort,
}

impl Trials {
    /// To the end of the grid, or as far as 50,000 steps go.
    pub fn new(problem: &Problem, grid: &Grid) -> Result<Self, PropagationError> {
        let problem = Problem { wants_attitude: true, ..problem.clone() };
        let (end, reached) = (grid.end(), within_reach(&problem, grid.end())?);
        let samples = || Grid::spread(grid.len(), MOST_SAMPLES).into_iter().map(|index| grid.time(index)).collect();
        let parts = || (0..=PARTS).map(|n| reached * f64::from(n) / f64::from(PARTS)).collect();
        let times: Vec<f64> = if reached < end { parts() } else { samples() };
        let mut trials = Self {
            exact: run(&mut Taylor::new(&problem, Stepper::Taylor.tightest())?, &times)?.0,
            floors: vec![0.0; times.len()],
            growth: if reached < end { (end / reached).powi(2) } else { 1.0 },
            problem,
            times,
        };
        for pattern in PATTERNS {
            let mut witness = Taylor::new(&nudged(&trials.problem, pattern), Stepper::Taylor.tightest())?;
            let (states, _) = run(&mut witness, &trials.times)?;
            for (floor, distance) in trials.floors.iter_mut().zip(attitude_distances(&trials.exact, &states)) {
                *floor = floor.max(distance + RESOLUTION);
            }
        }
        let rounded = if trials.problem.is_general() { ROUNDED_SERIES } else { 1.0 };
        let mut most = 0.0_f64;
        for floor in &mut trials.floors {
            most = most.max(rounded * *floor);
            *floor = most;
        }
        Ok(trials)
    }

    /// How far roundings move the motion in the whole run, rad: no stepper in f64 can promise less.
    pub fn floor(&self) -> f64 {
        self.growth * self.floors.last().copied().unwrap_or(0.0)
    }

    /// Until when they move it by no more than `error` rad, s.
    pub fn floor_below_until(&self, error: f64) -> f64 {
        let count = self.floors.partition_point(|floor| *floor <= error);
        count.checked_sub(1).map_or(0.0, |index| self.times[index])
    }

    /// The last instant compared, s.
    pub fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// A run by a stepper; `None` where it fails for want of accuracy.
    pub fn by(&self, stepper: Stepper, tolerance: f64) -> Option<Trial> {
        let (states, effort) = run(&mut *stepper.start(&self.problem, tolerance).ok()?, &self.times).ok()?;
        Some(Trial { error: self.growth * attitude_distance(&self.exact, &states), effort })
    }
}

fn run(propagator: &mut dyn Propagator, times: &[f64]) -> Result<(States, Effort), PropagationError> {
    let mut states = States::default();
    propagator.fill(times, &mut states)?;
    Ok((states, propagator.effort()))
}

/// `end`, or the largest of its halves, quarters … that takes no more than [`MOST_STEPS`], s. However fast things happen,
/// and whenever they begin to, no more steps are made to find out.
fn within_reach(problem: &Problem, end: f64) -> Result<f64, PropagationError> {
    let reached = Taylor::new(problem, COUNTING)?.reach(end, MOST_STEPS)?;
    Ok((0..=HALVINGS).map(|halvings| libm::ldexp(end, -halvings)).find(|part| *part <= reached).unwrap_or(0.0))
}
