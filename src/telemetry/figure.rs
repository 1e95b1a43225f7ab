use nalgebra::Vector3;

use crate::body::State;
use crate::dynamics::{Problem, Torque, radial_direction};

/// The axis of a body by which people tell how it leans, and what it leans from.
///
/// * A body that nothing acts on and that has two equal moments: its axis of symmetry, and L.
/// * A top, of two equal moments, held on its axis of symmetry under a steady force: the axis from the pivot to where the
///   force acts, and up (against the force).
/// * A body of two equal moments whose magnetic dipole is on its axis of symmetry, in a steady field: the axis towards the
///   dipole's north, and the field.
/// * A body in a gravity gradient: its axis of the least moment, and the local vertical, away from the attracting centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FigureAxis {
    /// Which principal axis.
    pub(super) axis: usize,
    /// Which way along it.
    pub(super) sign: f64,
    reference: Reference,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Reference {
    /// L.
    Momentum,
    /// Against the weight, or along the field; unit, world axes.
    Up(Vector3<f64>),
    /// Of an orbit with this mean motion, rad/s.
    Vertical(f64),
}

impl FigureAxis {
    /// Of this problem, if it has one.
    #[must_use]
    pub fn of(problem: &Problem) -> Option<Self> {
        let moments = problem.moments.vector();
        let symmetry = symmetry_axis(&moments);
        let (axis, sign, reference) = match problem.loads.as_slice() {
            [] => {
                let axis = symmetry.filter(|_| problem.initial.angular_velocity.in_body() != Vector3::zeros())?;
                (axis, 1.0, Reference::Momentum)
            }
            [load] => match load.torque {
                Torque::ForceWorld { force, arm } => {
                    let axis = symmetry.filter(|axis| others(*axis).iter().all(|other| arm[*other] == 0.0))?;
                    (axis, 1.0_f64.copysign(arm[axis]), Reference::Up(-force.try_normalize(0.0)?))
                }
                Torque::MagneticDipole { dipole, field } => {
                    let axis = symmetry.filter(|axis| others(*axis).iter().all(|other| dipole[*other] == 0.0))?;
                    (axis, 1.0_f64.copysign(dipole[axis]), Reference::Up(field.try_normalize(0.0)?))
                }
                Torque::GravityGradient { mean_motion } => (moments.imin(), 1.0, Reference::Vertical(mean_motion)),
                _ => return None,
            },
            _ => return None,
        };
        let figure = Self { axis, sign, reference };
        // Of a top the force says which end is up, of a magnet its north; of the others the end is taken that leans less at first.
        let along = figure.in_body(problem, 0.0, &problem.initial)[axis];
        let turned = !matches!(reference, Reference::Up(_)) && along < 0.0;
        Some(Self { sign: if turned { -sign } else { sign }, ..figure })
    }

    /// Whether the rate at which the axis goes round its reference tells something: the vertical of an orbit turns itself.
    #[must_use]
    pub const fn precesses(&self) -> bool {
        !matches!(self.reference, Reference::Vertical(_))
    }

    /// Up, unit, world axes, where the axis leans from it.
    pub(super) const fn up(&self) -> Option<Vector3<f64>> {
        match self.reference {
            Reference::Up(up) => Some(up),
            Reference::Momentum | Reference::Vertical(_) => None,
        }
    }

    /// The angle between axis and reference, rad, 0 to π; exact near both ends.
    #[must_use]
    pub fn tilt(&self, problem: &Problem, time: f64, state: &State) -> f64 {
        let reference = self.in_body(problem, time, state);
        let [one, other] = others(self.axis);
        libm::atan2(libm::hypot(reference[one], reference[other]), self.sign * reference[self.axis])
    }

    /// The rate at which the axis goes round its reference, rad/s; 0 where it lies along it, so that nothing goes round.
    ///
    /// With p the unit reference and p⊥, ω⊥ the parts across the axis: p⊥ · ω⊥ / p⊥².
    #[must_use]
    pub fn precession_rate(&self, problem: &Problem, time: f64, state: &State) -> f64 {
        let reference = self.in_body(problem, time, state);
        let omega = state.angular_velocity.in_body();
        let [one, other] = others(self.axis);
        let across = reference[one] * reference[one] + reference[other] * reference[other];
        if across == 0.0 {
            return 0.0;
        }
        reference.norm() * (reference[one] * omega[one] + reference[other] * omega[other]) / across
    }

    /// The reference in principal axes, of any length.
    fn in_body(&self, problem: &Problem, time: f64, state: &State) -> Vector3<f64> {
        match self.reference {
            Reference::Momentum => state.angular_velocity.momentum(problem.moments).in_body(),
            Reference::Up(up) => state.attitude.to_body(&up),
            Reference::Vertical(mean_motion) => state.attitude.to_body(&radial_direction(mean_motion, time)),
        }
    }
}

/// The axis of a moment that differs from the two others, which are equal.
pub(super) fn symmetry_axis(moments: &Vector3<f64>) -> Option<usize> {
    [0, 1, 2].into_iter().find(|axis| {
        let [one, other] = others(*axis);
        moments[one] == moments[other] && moments[*axis] != moments[one]
    })
}

/// The two that follow in cyclic order.
pub(super) const fn others(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}
