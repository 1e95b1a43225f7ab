use nalgebra::Vector3;

use super::control::{BDot, QuaternionFeedback, RateFeedback};
use super::drag::{quadratic_damping, quadratic_drag};
use super::{FormulaLoad, InnerSphere, Push, Spring, Symbols};
use crate::body::State;
use crate::dynamics::{DynamicsError, SpringCloud};
use crate::numerics::Tape;

/// What acts, of kinds that need more than constants, couples and damping.
#[derive(Debug, Clone, PartialEq)]
pub enum General {
    /// A moment or a force by formulae.
    Formula(FormulaLoad),
    /// A spring from the world to a point of the body.
    Spring(Spring),
    /// τ = −c |ω| ω.
    QuadraticDamping {
        /// c, N m s², not negative.
        coefficient: f64,
    },
    /// F = −c |u| u at a point of the body that moves with u.
    QuadraticDrag {
        /// c, kg/m, not negative.
        coefficient: f64,
        /// The point, in principal axes from the reference point, m.
        arm: Vector3<f64>,
    },
    /// A sphere in a film of fluid inside the body.
    InnerSphere(InnerSphere),
    /// Springs between the particles that the body is made of.
    Cloud(SpringCloud),
    /// Towards a target attitude.
    QuaternionFeedback(QuaternionFeedback),
    /// Against ω.
    RateFeedback(RateFeedback),
    /// Against the change of a magnetic field, by coils.
    BDot(BDot),
}

impl General {
    /// Its moment and force, as operations.
    pub fn lay_out(&self, tape: &mut Tape, symbols: &Symbols) -> Push {
        match self {
            Self::Formula(load) => load.lay_out(tape, symbols),
            Self::Spring(spring) => spring.lay_out(tape, symbols),
            Self::QuadraticDamping { coefficient } => quadratic_damping(tape, symbols, *coefficient),
            Self::QuadraticDrag { coefficient, arm } => quadratic_drag(tape, symbols, *coefficient, *arm),
            Self::InnerSphere(sphere) => sphere.lay_out(tape, symbols),
            // Of the body as a whole: they push and turn it nowhere.
            Self::Cloud(_) => Push::none(tape),
            Self::QuaternionFeedback(control) => control.lay_out(tape, symbols),
            Self::RateFeedback(control) => control.lay_out(tape, symbols),
            Self::BDot(control) => control.lay_out(tape, symbols),
        }
    }

    /// Why only Taylor series follow it, where it moves something inside the body: the angular momentum of all stays.
    #[must_use]
    pub const fn moves_inside(&self) -> Option<DynamicsError> {
        match self {
            Self::InnerSphere(_) => Some(DynamicsError::InnerSphere),
            Self::Cloud(_) => Some(DynamicsError::Particles),
            _ => None,
        }
    }

    /// Whether it depends on where the reference point is, or how fast it moves.
    #[must_use]
    pub fn looks_at_translation(&self) -> bool {
        match self {
            Self::Formula(load) => load.looks_at_translation(),
            Self::Spring(_) | Self::QuadraticDrag { .. } => true,
            _ => false,
        }
    }

    /// Whether it pushes the reference point.
    #[must_use]
    pub fn pushes(&self) -> bool {
        match self {
            Self::Formula(load) => load.pushes(),
            Self::Spring(_) | Self::QuadraticDrag { .. } => true,
            _ => false,
        }
    }

    /// The potential energy in `state`, J, of what has one while it acts.
    #[must_use]
    pub fn potential_energy(&self, state: &State) -> Option<f64> {
        match self {
            Self::Spring(spring) => spring.potential_energy(state),
            _ => None,
        }
    }

    /// Whether it conserves energy, its own counted.
    #[must_use]
    pub fn is_conservative(&self) -> bool {
        matches!(self, Self::Spring(spring) if spring.damping == 0.0)
    }

    /// What it is, for people.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Formula(load) => load.name(),
            Self::Spring(Spring { is_tether: true, .. }) => "tether",
            Self::Spring(_) => "spring",
            Self::QuadraticDamping { .. } => "quadratic damping",
            Self::QuadraticDrag { .. } => "quadratic drag",
            Self::InnerSphere(_) => "inner sphere",
            Self::Cloud(_) => "springs between particles",
            Self::QuaternionFeedback(_) => "quaternion feedback",
            Self::RateFeedback(_) => "rate feedback",
            Self::BDot(_) => "B-dot",
        }
    }
}
