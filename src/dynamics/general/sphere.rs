use nalgebra::Vector3;

use super::{Push, Symbols};
use crate::numerics::{Node, Tape};

/// A sphere inside the body, about its reference point, in a film of fluid: it turns with the body but for σ, and drags on it
/// with c σ. It takes energy, and leaves the angular momentum of both as it is. The body's moments hold the sphere too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InnerSphere {
    /// J, kg m², below each of the body's moments.
    pub inertia: f64,
    /// c, N m s, not negative.
    pub coefficient: f64,
    /// σ at t = 0: the sphere's rates less the body's, principal axes, rad/s.
    pub initial: Vector3<f64>,
}

impl InnerSphere {
    /// On the body without the sphere: c σ.
    pub(super) fn lay_out(self, tape: &mut Tape, symbols: &Symbols) -> Push {
        let coefficient = tape.constant(self.coefficient);
        let moment = tape.scaled(coefficient, symbols.inner);
        Push::moment(tape, moment)
    }

    /// σ̇ = −(c/J) σ − ω̇ − ω × σ.
    pub fn relative_acceleration(self, tape: &mut Tape, symbols: &Symbols, acceleration: [Node; 3]) -> [Node; 3] {
        let (coefficient, inertia) = (tape.constant(self.coefficient), tape.constant(self.inertia));
        let rate = tape.quotient(coefficient, inertia);
        let (dragged, across) = (tape.scaled(rate, symbols.inner), tape.cross(symbols.rates, symbols.inner));
        let sum = tape.sums(dragged, acceleration);
        let sum = tape.sums(sum, across);
        sum.map(|component| tape.negative(component))
    }

    /// J σ, N m s: what the sphere adds to the angular momentum Iω, principal axes.
    #[must_use]
    pub fn momentum(self, relative: &Vector3<f64>) -> Vector3<f64> {
        self.inertia * relative
    }

    /// J (ω·σ + ½ σ²), J: what the sphere adds to the energy ½ ω·Iω.
    #[must_use]
    pub fn energy(self, omega: &Vector3<f64>, relative: &Vector3<f64>) -> f64 {
        self.inertia * (omega.dot(relative) + 0.5 * relative.norm_squared())
    }
}
