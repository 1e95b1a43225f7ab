use nalgebra::Vector3;

use super::{Push, Symbols};
use crate::body::State;
use crate::numerics::{Node, Tape};

/// A spring, and a damper beside it, from a point of the world to a point of the body.
///
/// Along the line from the anchor to the point, at a length ℓ: F = −(k (ℓ − ℓ₀) + c ℓ̇). A tether pulls only:
/// F = −max(0, k (ℓ − ℓ₀)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// World axes, m.
    pub anchor: Vector3<f64>,
    /// The body's point, in principal axes from the reference point, m.
    pub arm: Vector3<f64>,
    /// k, N/m, positive.
    pub stiffness: f64,
    /// c, N s/m, not negative; zero for a tether.
    pub damping: f64,
    /// ℓ₀, m, not negative.
    pub rest_length: f64,
    /// Whether it goes slack where it is shorter than at rest.
    pub is_tether: bool,
}

impl Spring {
    pub(super) fn lay_out(&self, tape: &mut Tape, symbols: &Symbols) -> Push {
        let arm = tape.vector(self.arm);
        let (arm_in_world, anchor) = (symbols.to_world(tape, arm), tape.vector(self.anchor));
        let point = tape.sums(symbols.position, arm_in_world);
        let reach = tape.differences(point, anchor);
        let stiffness = tape.constant(self.stiffness);
        // Without a length at rest or a damper, the force is linear in the reach, and needs no direction.
        if self.rest_length == 0.0 && self.damping == 0.0 {
            let pull = tape.negative(stiffness);
            let force = tape.scaled(pull, reach);
            return Push::force(tape, symbols, force, self.arm);
        }
        let square = tape.dot(reach, reach);
        let (length, rest) = (tape.root(square), tape.constant(self.rest_length));
        let mut stretch = tape.difference(length, rest);
        if self.is_tether {
            let zero = tape.constant(0.0);
            stretch = tape.larger(stretch, zero);
        }
        let mut tension = tape.product(stiffness, stretch);
        if self.damping > 0.0 {
            let damped = self.damper(tape, symbols, reach, length);
            tension = tape.sum(tension, damped);
        }
        let opposite = tape.negative(tension);
        let factor = tape.quotient(opposite, length);
        let force = tape.scaled(factor, reach);
        Push::force(tape, symbols, force, self.arm)
    }

    /// c ℓ̇.
    fn damper(&self, tape: &mut Tape, symbols: &Symbols, reach: [Node; 3], length: Node) -> Node {
        let velocity = point_velocity(tape, symbols, self.arm);
        let along = tape.dot(reach, velocity);
        let (coefficient, lengthening) = (tape.constant(self.damping), tape.quotient(along, length));
        tape.product(coefficient, lengthening)
    }

    /// How much longer than at rest it is in `state`, m.
    #[must_use]
    pub fn stretch(&self, state: &State) -> f64 {
        let point = state.position + state.attitude.to_world(&self.arm);
        let stretch = (point - self.anchor).norm() - self.rest_length;
        if self.is_tether { stretch.max(0.0) } else { stretch }
    }

    /// ½ k (ℓ − ℓ₀)², J, of one without a damper.
    #[must_use]
    pub fn potential_energy(&self, state: &State) -> Option<f64> {
        let stretch = self.stretch(state);
        (self.damping == 0.0).then_some(0.5 * self.stiffness * stretch * stretch)
    }
}

/// v + R (ω × arm), world axes.
pub(super) fn point_velocity(tape: &mut Tape, symbols: &Symbols, arm: Vector3<f64>) -> [Node; 3] {
    let arm = tape.vector(arm);
    let in_body = tape.cross(symbols.rates, arm);
    let turning = symbols.to_world(tape, in_body);
    tape.sums(symbols.velocity, turning)
}
