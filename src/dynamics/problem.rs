use nalgebra::Vector3;

use super::{DynamicsError, General, GeneralLoad, InnerSphere, Load, SpringCloud, Torque, momentum_in_world};
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

    /// The particles that the body is made of, if springs join them; the first of several clouds.
    #[must_use]
    pub fn cloud(&self) -> Option<&SpringCloud> {
        self.general().find_map(|load| match &load.kind {
            General::Cloud(cloud) => Some(cloud),
            _ => None,
        })
    }

    /// Why only Taylor series follow the motion, where something inside the body moves by itself.
    #[must_use]
    pub fn moves_inside(&self) -> Option<DynamicsError> {
        self.general().find_map(|load| load.kind.moves_inside())
    }

    /// The loads without a recurrence of their own.
    fn general(&self) -> impl Iterator<Item = &GeneralLoad> {
        self.loads.iter().filter_map(|load| match &load.torque {
            Torque::General(load) => Some(load.as_ref()),
            _ => None,
        })
    }

    /// Whether the body carries a rotor.
    #[must_use]
    pub fn has_rotor(&self) -> bool {
        self.loads.iter().any(|load| matches!(load.torque, Torque::Rotor { .. }))
    }

    /// The momentum of all rotors relative to the body at `time` in s, N m s; principal axes.
    #[must_use]
    pub fn rotor_momentum(&self, time: f64) -> Vector3<f64> {
        rotor_momentum(&self.loads, time)
    }

    /// How large the momenta of rotors become, N m s: what their sum with the body's, which may be zero, is measured by.
    #[must_use]
    pub fn largest_rotor_momentum(&self) -> f64 {
        let of_load = |load: &Load| match &load.torque {
            Torque::Rotor { momentum } => momentum.largest_at_knots(),
            _ => 0.0,
        };
        self.loads.iter().map(of_load).sum()
    }

    /// I ω + h, the angular momentum of the body and its rotors, N m s; principal axes.
    #[must_use]
    pub fn momentum_in_body(&self, time: f64, state: &State) -> Vector3<f64> {
        let of_body = state.angular_velocity.momentum(self.moments).in_body();
        if self.has_rotor() { of_body + self.rotor_momentum(time) } else { of_body }
    }

    /// The same in world axes: what only moments from outside change.
    #[must_use]
    pub fn momentum_in_world(&self, time: f64, state: &State) -> Vector3<f64> {
        if self.has_rotor() {
            state.attitude.to_world(&self.momentum_in_body(time, state))
        } else {
            momentum_in_world(self.moments, state)
        }
    }
}

/// The momentum of all rotors among `loads` relative to the body at `time` in s, N m s; principal axes.
#[must_use]
pub fn rotor_momentum(loads: &[Load], time: f64) -> Vector3<f64> {
    let of_load = |load: &Load| match &load.torque {
        Torque::Rotor { momentum } if load.window.contains(time) => momentum.at(time),
        _ => Vector3::zeros(),
    };
    loads.iter().map(of_load).sum()
}
