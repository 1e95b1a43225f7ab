use nalgebra::Vector3;

use super::spring::point_velocity;
use super::{Push, Symbols};
use crate::numerics::{Node, Tape};

/// Where a speed is this small, rad/s or m/s, the corner of |u| u at rest is rounded off: √(u² + ε²) u has a Taylor series
/// everywhere, and differs from it by less than 1e-20 of what it is at unit speed.
const ROUNDING: f64 = 1e-10;

/// τ = −c |ω| ω.
pub(super) fn quadratic_damping(tape: &mut Tape, symbols: &Symbols, coefficient: f64) -> Push {
    let moment = against(tape, coefficient, symbols.rates);
    Push::moment(tape, moment)
}

/// F = −c |u| u at a point of the body that moves with u.
pub(super) fn quadratic_drag(tape: &mut Tape, symbols: &Symbols, coefficient: f64, arm: Vector3<f64>) -> Push {
    let velocity = point_velocity(tape, symbols, arm);
    let force = against(tape, coefficient, velocity);
    Push::force(tape, symbols, force, arm)
}

/// −c |u| u.
fn against(tape: &mut Tape, coefficient: f64, u: [Node; 3]) -> [Node; 3] {
    let (opposite, rounding) = (tape.constant(-coefficient), tape.constant(ROUNDING * ROUNDING));
    let square = tape.dot(u, u);
    let rounded = tape.sum(square, rounding);
    let speed = tape.root(rounded);
    let factor = tape.product(opposite, speed);
    tape.scaled(factor, u)
}
