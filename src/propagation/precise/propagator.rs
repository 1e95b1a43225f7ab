use super::PreciseTaylor;
use super::acting::Acting;
use super::series::{ORDER, Series, exact};
use super::state::PreciseState;
use crate::dynamics::{DynamicsError, Problem, Schedule};
use crate::numerics::DoubleDouble;
use crate::propagation::{Effort, PropagationError};

/// Motion under loads whose equations are bilinear: see [`PreciseTaylor`].
#[derive(Debug, Clone)]
pub(super) struct PreciseBilinear {
    problem: Problem,
    schedule: Schedule,
    /// The current span's number, what acts in it, and its end, s.
    current: usize,
    acting: Acting,
    edge: f64,
    series: Series,
    /// Of the series, s: a power of two.
    unit: f64,
    /// Where the series starts, s.
    start: DoubleDouble,
    /// Where the step ends, s, and the state there.
    end: DoubleDouble,
    state: PreciseState,
    tolerance: f64,
    effort: Effort,
}

impl PreciseBilinear {
    /// The longest step, s.
    const LONGEST_STEP: f64 = 1e100;
    /// The longest step of a damped body that moves, in units of what is fastest: its series reaches no farther.
    const LONGEST_RATIO: f64 = 16.0;
    /// rad/s: a body damped to less than this stands still. Last terms of its series would be below the smallest number.
    const REST: f64 = 1e-240;

    /// At t = 0.
    pub fn new(problem: &Problem) -> Result<Self, DynamicsError> {
        let schedule = Schedule::new(problem)?;
        let state = PreciseState::from_state(&problem.initial);
        let acting = Acting::at(problem, 0.0);
        let mut series = Series::new();
        series.expand(&state, DoubleDouble::ZERO, &acting, 1.0, 0);
        Ok(Self {
            problem: problem.clone(),
            edge: schedule.bounds(0).1,
            schedule,
            current: 0,
            acting,
            series,
            unit: 1.0,
            start: DoubleDouble::ZERO,
            end: DoubleDouble::ZERO,
            state,
            tolerance: PreciseTaylor::TOLERANCE,
            effort: Effort::default(),
        })
    }

    /// The same by other steps.
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// The state at a time within the last step, s.
    pub fn within(&self, time: DoubleDouble) -> PreciseState {
        let mut state = self.series.state((time - self.start).scale(1.0 / self.unit));
        state.normalise();
        state
    }

    /// Where the last step ends, s.
    pub fn end(&self) -> DoubleDouble {
        self.end
    }

    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// Makes one step.
    pub fn advance(&mut self) -> Result<(), PropagationError> {
        if self.end >= DoubleDouble::from(self.edge) {
            // The last span ends at infinity, so there is a next one.
            self.current += 1;
            let (start, end) = self.schedule.bounds(self.current);
            (self.acting, self.edge) = (Acting::at(&self.problem, start), end);
        }
        let (acting, time, edge) = (&self.acting, self.end, self.edge);
        self.unit = unit(&self.state, time, acting, edge, &mut self.series);
        self.series.expand(&self.state, time, acting, self.unit, ORDER);
        self.start = time;
        self.effort.evaluations += 1;
        let ratio = step_ratio(&self.series, self.tolerance);
        let is_damped = acting.damping.iter().any(|rate| rate.hi() > 0.0);
        let moves = largest(&self.series.rates, 0).max(largest(&self.series.rates, 1)) > 0.0;
        // What is damped to all but rest has last terms below the smallest number, and they say nothing of the step.
        let ratio = if is_damped && moves { ratio.min(Self::LONGEST_RATIO) } else { ratio };
        let step = (self.unit * ratio).min(Self::LONGEST_STEP);
        let to_edge = if edge.is_finite() { DoubleDouble::from(edge) - time } else { DoubleDouble::from(edge) };
        let ends_on_edge = to_edge.hi() <= step;
        let step = if ends_on_edge { to_edge } else { DoubleDouble::from(step) };
        let mut state = self.series.state(step.scale(1.0 / self.unit));
        state.normalise();
        if !state.is_finite() {
            return Err(PropagationError::NotFinite { time: time.hi() });
        }
        if !ends_on_edge && time.hi() + step.hi() == time.hi() {
            return Err(PropagationError::StepTooSmall { time: time.hi(), step: step.hi() });
        }
        if is_damped && state.angular_velocity.iter().all(|rate| rate.hi().abs() < Self::REST) {
            state.angular_velocity = [DoubleDouble::ZERO; 3];
        }
        self.state = state;
        self.end = if ends_on_edge { DoubleDouble::from(edge) } else { time + step };
        self.effort.include_step(step.hi());
        Ok(())
    }
}

/// A power of two near the step's length, from how fast things happen in a state: no coefficient then over- or underflows.
///
/// What changes with time is as fast as the span to `edge` is short, at least: beyond it, its polynomials need no meaning.
fn unit(state: &PreciseState, time: DoubleDouble, acting: &Acting, edge: f64, series: &mut Series) -> f64 {
    series.expand(state, time, acting, 1.0, 1);
    let turning = largest(&series.rates, 0).max(largest(&series.rates, 1).sqrt());
    let fading = acting.damping.iter().fold(0.0, |most: f64, value| most.max(value.hi()));
    let orbiting = acting.gradient.map_or(0.0, |(_, mean_motion)| mean_motion.abs());
    let driving = series.drive.as_ref().map_or(0.0, |drive| drive.turning().max(1.0 / (edge - time.hi())));
    let fastest = turning.max(fading).max(orbiting).max(driving);
    let whole = libm::floor(-libm::log2(fastest));
    if (-1000.0..1000.0).contains(&whole) { libm::exp2(whole) } else { 1.0 }
}

/// The σ at which the last two coefficients still add no more than the tolerance, relative to q, ω and x as they are
/// over the step; infinity where they vanish.
fn step_ratio(series: &Series, tolerance: f64) -> f64 {
    let size = |rows: &[[DoubleDouble; ORDER + 1]; 3]| (0..3).map(|k| largest(rows, k)).fold(0.0, f64::max);
    let (rates, position) = (size(&series.rates), size(&series.position));
    let relative = |value: f64, size: f64| if size > 0.0 { value / size } else { 0.0 };
    let ratio = |k: usize| {
        let last = largest(&series.attitude, k)
            .max(relative(largest(&series.rates, k), rates))
            .max(relative(largest(&series.position, k), position));
        if last > 0.0 { libm::pow(tolerance / last, 1.0 / exact(k)) } else { f64::INFINITY }
    };
    ratio(ORDER - 1).min(ratio(ORDER))
}

fn largest<const N: usize>(rows: &[[DoubleDouble; ORDER + 1]; N], k: usize) -> f64 {
    rows.iter().fold(0.0, |most, row| row[k].hi().abs().max(most))
}
