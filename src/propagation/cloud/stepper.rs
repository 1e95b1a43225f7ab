use super::fit::fit;
use super::motion::{Motion, Springs};
use super::series::Series;
use super::start::start;
use super::vector::unit;
use crate::dynamics::{DynamicsError, Problem};
use crate::numerics::{DoubleDouble, Scalar};
use crate::propagation::general::{LONGEST_STEP, power_of_two};
use crate::propagation::{Effort, PropagationError};

/// From step to step, with series in `F`. Steps do not depend on sample times.
#[derive(Debug, Clone)]
pub(super) struct Stepper<F> {
    pub springs: Springs,
    series: Series<F>,
    tolerance: f64,
    /// Of the attitude: the turn whose square no longer counts, rad.
    enough: f64,
    start: DoubleDouble,
    end: DoubleDouble,
    /// At `end`.
    motion: Motion,
    /// At `start` and at `end`.
    attitudes: [[F; 4]; 2],
    /// Of the next series, s.
    unit: f64,
    effort: Effort,
}

/// How exactly a stepper goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Exactness {
    pub order: usize,
    pub tolerance: f64,
    /// Of the attitude: the turn whose square no longer counts, rad.
    pub enough: f64,
}

impl<F: Scalar> Stepper<F> {
    /// At t = 0, of a problem with a cloud that nothing else acts on.
    pub fn new(problem: &Problem, exactness: Exactness) -> Result<Self, DynamicsError> {
        let Some(cloud) = problem.cloud().filter(|_| problem.loads.len() == 1) else {
            return Err(DynamicsError::LoadedParticles);
        };
        let springs = Springs::new(cloud);
        let motion = start(problem, &springs);
        let attitude = unit(problem.initial.attitude.wxyz().map(F::from));
        let [_, highest] = cloud.natural_frequencies();
        // Dampers beside the springs brake each vibration in proportion to the square of its frequency.
        let braked = highest * highest * cloud.springs().damping / cloud.springs().stiffness;
        Ok(Self {
            series: Series::new(&springs, exactness.order, motion.clone()),
            springs,
            tolerance: exactness.tolerance,
            enough: exactness.enough,
            start: DoubleDouble::ZERO,
            end: DoubleDouble::ZERO,
            motion,
            attitudes: [attitude; 2],
            unit: power_of_two(1.0 / highest.max(braked)),
            effort: Effort::default(),
        })
    }

    /// The same by other steps.
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    pub fn order(&self) -> usize {
        self.series.order
    }

    /// Where the last step ends, s.
    pub fn end(&self) -> DoubleDouble {
        self.end
    }

    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// The motion at a time within the last step, s, and the attitude of the whole.
    pub fn at(&self, time: DoubleDouble) -> Result<(Motion, [F; 4]), PropagationError> {
        let motion = if time == self.end { self.motion.clone() } else { self.series.after(time - self.start) };
        let attitude = fit(&self.springs, &motion, self.attitudes[0], self.enough);
        Ok((motion, attitude.ok_or(PropagationError::NoShape { time: time.hi() })?))
    }

    /// Makes one step.
    pub fn advance(&mut self) -> Result<(), PropagationError> {
        let time = self.end.hi();
        self.series.expand(&self.springs, self.motion.clone(), self.unit);
        self.effort.evaluations += 1;
        let step = self.series.reach(self.tolerance).min(LONGEST_STEP);
        let motion = self.series.after(DoubleDouble::from(step));
        if !motion.is_finite() {
            return Err(PropagationError::NotFinite { time });
        }
        if time + step == time {
            return Err(PropagationError::StepTooSmall { time, step });
        }
        let attitude = fit(&self.springs, &motion, self.attitudes[1], self.enough);
        self.start = self.end;
        self.end += DoubleDouble::from(step);
        self.attitudes = [self.attitudes[1], attitude.ok_or(PropagationError::NoShape { time })?];
        self.motion = motion;
        self.unit = power_of_two(step);
        self.effort.include_step(step);
        Ok(())
    }
}
