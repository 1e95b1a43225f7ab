use super::fit::{momentum, rates};
use super::motion::Motion;
use super::stepper::{Exactness, Stepper};
use super::vector::Vector;
use crate::dynamics::{DynamicsError, Problem};
use crate::numerics::DoubleDouble;
use crate::propagation::sampling::check_times;
use crate::propagation::{Ballistic, CloudStates, Effort, PropagationError, Propagator, States};

/// Taylor series in f64 of every particle of a cloud, with dense output.
#[derive(Debug, Clone)]
pub(in crate::propagation) struct CloudTaylor {
    stepper: Stepper<f64>,
    fall: Ballistic,
    wants_attitude: bool,
    wants_translation: bool,
    latest: f64,
}

impl CloudTaylor {
    /// From a problem, the order of the series, and the error allowed per step.
    pub fn new(problem: &Problem, order: usize, tolerance: f64) -> Result<Self, DynamicsError> {
        Ok(Self {
            stepper: Stepper::new(problem, Exactness { order, tolerance, enough: 1e-9 })?,
            fall: Ballistic::new(problem),
            wants_attitude: problem.wants_attitude,
            wants_translation: problem.wants_translation,
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

    /// Of the particles: where and how fast they are, what the springs do to each, and the energies of all.
    fn put_particles(&self, row: usize, motion: &Motion, cloud: &mut CloudStates) {
        let (forces, elastic) = self.stepper.springs.forces(motion);
        let mut kinetic = 0.0;
        let masses = self.stepper.springs.cloud.masses();
        for (particle, (columns, mass)) in cloud.particles.iter_mut().zip(masses).enumerate() {
            let (arm, velocity) = (motion.positions[particle], motion.velocities[particle]);
            let (arm, velocity): (Vector<f64>, Vector<f64>) = (Motion::rounded(arm), Motion::rounded(velocity));
            put(&mut columns.arm, row, arm);
            put(&mut columns.velocity, row, velocity);
            put(&mut columns.force, row, forces[particle]);
            kinetic += 0.5 * mass * velocity.iter().map(|component| component * component).sum::<f64>();
        }
        (cloud.kinetic_energy[row], cloud.elastic_energy[row]) = (kinetic, elastic);
    }
}

impl Propagator for CloudTaylor {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.latest)?;
        states.reset(times.len(), self.wants_attitude, self.wants_translation);
        states.cloud.reset(self.stepper.springs.cloud.masses().len(), times.len());
        for (row, &time) in times.iter().enumerate() {
            let wanted = DoubleDouble::from(time);
            while self.stepper.end() < wanted {
                self.stepper.advance()?;
            }
            let (motion, attitude) = self.stepper.at(wanted)?;
            put(&mut states.angular_velocity, row, rates(&self.stepper.springs, &motion, attitude));
            put(&mut states.cloud.momentum, row, momentum(&self.stepper.springs, &motion));
            if self.wants_attitude {
                put(&mut states.attitude, row, attitude);
            }
            self.put_particles(row, &motion, &mut states.cloud);
            self.latest = time;
        }
        if self.wants_translation {
            self.fall.fill(times, states);
        }
        Ok(())
    }

    fn effort(&self) -> Effort {
        self.stepper.effort()
    }
}

fn put<const N: usize>(columns: &mut [Vec<f64>; N], row: usize, values: [f64; N]) {
    for (column, value) in columns.iter_mut().zip(values) {
        column[row] = value;
    }
}
