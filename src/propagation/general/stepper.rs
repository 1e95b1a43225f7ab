use super::equations::equations;
use super::motion::{Motion, Series};
use super::step::{LONGEST_STEP, power_of_two, step_ratio};
use crate::dynamics::{DynamicsError, Problem, Schedule};
use crate::numerics::{DoubleDouble, Scalar, Tape};
use crate::propagation::{Effort, PropagationError};

/// From step to step, with series in `F`. Steps end exactly where a load starts or ends, where a function of time has a knot,
/// and where a result on the tape goes from one of its branches to another; they do not depend on sample times.
#[derive(Debug, Clone)]
pub(in crate::propagation) struct Stepper<F> {
    problem: Problem,
    schedule: Schedule,
    /// The current span's number, its equations of motion, and its end, s.
    current: usize,
    tape: Tape,
    edge: f64,
    order: usize,
    tolerance: f64,
    series: Series<F>,
    start: DoubleDouble,
    end: DoubleDouble,
    /// At `end`.
    motion: Motion,
    /// Of the next series, s; none where nothing is known of it.
    unit: Option<f64>,
    effort: Effort,
}

impl<F: Scalar> Stepper<F> {
    /// How often the unit of a first series is mended.
    const MOST_UNITS: usize = 40;

    /// At t = 0, of problems whose loads make equations of motion.
    pub fn new(problem: &Problem, order: usize, tolerance: f64) -> Result<Self, DynamicsError> {
        let schedule = Schedule::new(problem)?;
        let (from, edge) = schedule.bounds(0);
        let tape = equations(problem, from);
        let (motion, start) = (Motion::new(problem), DoubleDouble::ZERO);
        Ok(Self {
            series: Series::new(&tape, 0, &motion, start, 1.0),
            problem: problem.clone(),
            schedule,
            current: 0,
            tape,
            edge,
            order,
            tolerance,
            start,
            end: start,
            motion,
            unit: None,
            effort: Effort::default(),
        })
    }

    /// The same by other steps.
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    pub fn order(&self) -> usize {
        self.order
    }

    /// Where the last step ends, s.
    pub fn end(&self) -> DoubleDouble {
        self.end
    }

    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// The motion at a time within the last step, s.
    pub fn at(&self, time: DoubleDouble) -> Motion {
        self.series.at(F::from_double((time - self.start).scale(1.0 / self.series.unit)))
    }

    /// Makes one step.
    pub fn advance(&mut self) -> Result<(), PropagationError> {
        if self.end >= DoubleDouble::from(self.edge) {
            // The last span ends at infinity, so there is a next one.
            self.current += 1;
            let (from, edge) = self.schedule.bounds(self.current);
            (self.tape, self.edge) = (equations(&self.problem, from), edge);
            self.unit = None;
        }
        let time = self.end;
        self.expand()?;
        let (tape, edge) = (&self.tape, self.edge);
        self.start = time;
        let ratio = step_ratio(&self.series, tape, self.tolerance);
        let longest = (self.series.unit * ratio).min(LONGEST_STEP);
        let to_edge = if edge.is_finite() { DoubleDouble::from(edge) - time } else { DoubleDouble::from(edge) };
        let ends_on_edge = to_edge.hi() <= longest;
        let step = if ends_on_edge { to_edge } else { DoubleDouble::from(longest) };
        let switch = self.series.expansion.first_switch(tape, self.order, step.hi() / self.series.unit);
        let ends_on_edge = ends_on_edge && switch.is_none();
        let step = switch.map_or(step, |sigma| DoubleDouble::from(sigma * self.series.unit));
        let motion = self.series.at(F::from_double(step.scale(1.0 / self.series.unit)));
        if !motion.is_finite() {
            return Err(PropagationError::NotFinite { time: time.hi() });
        }
        if !ends_on_edge && time.hi() + step.hi() == time.hi() {
            return Err(PropagationError::StepTooSmall { time: time.hi(), step: step.hi() });
        }
        self.end = if ends_on_edge { DoubleDouble::from(edge) } else { time + step };
        self.motion = motion;
        self.unit = Some(power_of_two(if switch.is_some() { longest } else { step.hi() }));
        self.effort.include_step(step.hi());
        Ok(())
    }

    /// The series of the motion from the end of the last step on, in a unit near the next one's length.
    fn expand(&mut self) -> Result<(), PropagationError> {
        let (tape, time) = (&self.tape, self.end);
        let not_finite = PropagationError::NotFinite { time: time.hi() };
        let known = self.unit.is_some();
        let first_unit = || {
            let first = Series::<F>::new(tape, 1, &self.motion, time, 1.0);
            power_of_two((1.0 / first.pace()).min(LONGEST_STEP))
        };
        let mut unit = self.unit.unwrap_or_else(first_unit);
        if self.series.order != self.order || !known {
            self.series = Series::new(tape, self.order, &self.motion, time, unit);
        } else {
            self.series.expand(tape, &self.motion, time, unit);
        }
        self.effort.evaluations += 1;
        for _ in 0..Self::MOST_UNITS {
            let ratio = step_ratio(&self.series, tape, self.tolerance);
            let is_finite = self.series.is_finite();
            // Far from the step's length, high orders over- or underflow.
            let factor = if !is_finite {
                libm::ldexp(1.0, -20)
            } else if (1.0 / 1024.0..=1024.0).contains(&ratio) || ratio == f64::INFINITY || unit >= LONGEST_STEP {
                return Ok(());
            } else {
                power_of_two(ratio)
            };
            unit = (unit * factor).min(power_of_two(LONGEST_STEP));
            self.series.expand(tape, &self.motion, time, unit);
            self.effort.evaluations += 1;
        }
        if self.series.is_finite() { Ok(()) } else { Err(not_finite) }
    }
}
