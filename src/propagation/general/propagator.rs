use super::stepper::Stepper;
use crate::dynamics::{DynamicsError, Problem};
use crate::numerics::DoubleDouble;
use crate::propagation::sampling::check_times;
use crate::propagation::{Effort, PropagationError, Propagator, States};

/// Taylor series in f64 of a tape, with dense output.
#[derive(Debug, Clone)]
pub(in crate::propagation) struct GeneralTaylor {
    stepper: Stepper<f64>,
    wants_attitude: bool,
    wants_translation: bool,
    has_sphere: bool,
    latest: f64,
}

impl GeneralTaylor {
    /// From a problem, the order of the series, and the error allowed per step.
    pub fn new(problem: &Problem, order: usize, tolerance: f64) -> Result<Self, DynamicsError> {
        Ok(Self {
            stepper: Stepper::new(problem, order, tolerance)?,
            wants_attitude: problem.wants_attitude,
            wants_translation: problem.wants_translation,
            has_sphere: problem.inner_sphere().is_some(),
            latest: 0.0,
        })
    }

    pub fn order(&self) -> usize {
        self.stepper.order()
    }

    /// Goes on towards `time`, s, by so many steps at most; how far it has come, s. Earlier times are then past.
    pub fn reach(&mut self, time: f64, steps: u64) -> Result<f64, PropagationError> {
        let limit = self.stepper.effort().steps.saturating_add(steps);
        let wanted = DoubleDouble::from(time);
        while self.stepper.end() < wanted && self.stepper.effort().steps < limit {
            self.stepper.advance()?;
        }
        self.latest = self.latest.max(self.stepper.end().hi().min(time));
        Ok(self.latest)
    }
}

impl Propagator for GeneralTaylor {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.latest)?;
        states.reset(times.len(), self.wants_attitude, self.wants_translation);
        for column in &mut states.inner {
            column.resize(if self.has_sphere { times.len() } else { 0 }, 0.0);
        }
        for (row, &time) in times.iter().enumerate() {
            let wanted = DoubleDouble::from(time);
            while self.stepper.end() < wanted {
                self.stepper.advance()?;
            }
            let motion = self.stepper.at(wanted);
            put(&mut states.angular_velocity, row, motion.rates());
            if self.wants_attitude {
                put(&mut states.attitude, row, motion.attitude());
            }
            if self.wants_translation {
                put(&mut states.position, row, motion.position());
                put(&mut states.velocity, row, motion.velocity());
            }
            if self.has_sphere {
                put(&mut states.inner, row, motion.inner());
            }
            self.latest = time;
        }
        Ok(())
    }

    fn effort(&self) -> Effort {
        self.stepper.effort()
    }
}

fn put<const N: usize>(columns: &mut [Vec<f64>; N], row: usize, values: [DoubleDouble; N]) {
    for (column, value) in columns.iter_mut().zip(values) {
        column[row] = value.hi();
    }
}
