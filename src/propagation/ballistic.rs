use nalgebra::Vector3;

use super::States;
use crate::dynamics::Problem;

/// Translation at constant acceleration, world axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ballistic {
    /// At t = 0, m.
    pub position: Vector3<f64>,
    /// At t = 0, m/s.
    pub velocity: Vector3<f64>,
    /// m/s².
    pub acceleration: Vector3<f64>,
}

impl Ballistic {
    /// The fall of the reference point under the problem's uniform gravity alone.
    #[must_use]
    pub fn new(problem: &Problem) -> Self {
        let (position, velocity) = (problem.initial.position, problem.initial.velocity);
        Self { position, velocity, acceleration: problem.gravity }
    }

    /// Fills the columns of position and velocity, already as long as `times` (s).
    pub fn fill(&self, times: &[f64], states: &mut States) {
        for axis in 0..3 {
            let (x, v, a) = (self.position[axis], self.velocity[axis], self.acceleration[axis]);
            let rows = states.position[axis].iter_mut().zip(&mut states.velocity[axis]);
            for ((position, velocity), &t) in rows.zip(times) {
                *position = x + t * (v + 0.5 * a * t);
                *velocity = v + a * t;
            }
        }
    }
}
