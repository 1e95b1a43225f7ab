use nalgebra::Vector3;

use super::{General, GeneralLoad, InnerSphere, Load, Torque};
use crate::body::{PrincipalMoments, State};

/// An initial value problem: a body, its state at t = 0, and what acts on it. All in principal axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// About the reference point, kg m².
    pub moments: PrincipalMoments,
    /// kg; present where a translation is propagated.
    pub mass: Option<f64>,
    /// At t = 0.
    pub initial: State,
    /// Everything that acts, in the order given.
    pub loads: Vec<Load>,
    /// Uniform acceleration of the reference point, world axes, m/s² (no moment about a centre of mass).
    pub gravity: Vector3<f64>,
    /// Whether the attitude is asked for; it is propagated all the same where a load needs it.
    pub wants_attitude: bool,
    /// Whether position and velocity are asked for.
    pub wants_translation: bool,
}

impl Problem {
    /// Whether a load has no recurrence of its own.
    #[must_use]
    pub fn is_general(&self) -> bool {
        self.general().next().is_some()
    }

    /// Whether a load looks at where the reference point is, or how fast it moves.
    #[must_use]
    pub fn looks_at_translation(&self) -> bool {
        self.general().any(|load| load.kind.looks_at_translation())
    }

    /// The sphere inside the body, if there is one; the first of several.
    #[must_use]
    pub fn inner_sphere(&self) -> Option<InnerSphere> {
        self.general().find_map(|load| match load.kind {
            General::InnerSphere(sphere) => Some(sphere),
            _ => None,
        })
    }

    /// The loads without a recurrence of their own.
    fn general(&self) -> impl Iterator<Item = &GeneralLoad> {
        self.loads.iter().filter_map(|load| match &load.torque {
            Torque::General(load) => Some(load.as_ref()),
            _ => None,
        })
    }
}
