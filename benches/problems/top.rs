//! A top, for the benchmarks that take one.

use nalgebra::Vector3;
use polhode::dynamics::{Load, Problem, Torque, Window};

use super::problems::free;

/// Lagrange's top, nearly asleep, under a force that is not vertical.
pub fn top() -> Problem {
    let torque = Torque::ForceWorld { force: Vector3::new(0.3, 0.0, -5.0), arm: Vector3::z() };
    let mut problem = free([1.0, 1.0, 0.5], [0.2, 0.1, 20.0]);
    problem.loads.push(Load { torque, window: Window::ALWAYS });
    problem
}
