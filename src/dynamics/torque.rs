use nalgebra::Vector3;

use crate::body::{Moment, State};

/// A moment that depends on time and state: a library user's own, for the Runge–Kutta methods.
pub trait TorqueModel {
    /// About the reference point, at `time` in s; `state` and the result in principal axes.
    fn moment(&self, time: f64, state: &State) -> Moment;
}

/// The span in which a load acts: `start ≤ t < end`, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// First instant, s; minus infinity for always.
    pub start: f64,
    /// First instant after it, s; infinity for ever.
    pub end: f64,
}

impl Window {
    /// From minus to plus infinity.
    pub const ALWAYS: Self = Self { start: f64::NEG_INFINITY, end: f64::INFINITY };

    /// Whether a load with this window acts at `time`.
    #[must_use]
    pub fn contains(self, time: f64) -> bool {
        self.start <= time && time < self.end
    }
}

/// What acts on a body. Vectors "in body" are in **principal** axes, arms go from the reference point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Torque {
    /// τ = constant in the body, N m.
    ConstantBody {
        /// In principal axes, N m.
        moment: Vector3<f64>,
    },
    /// τ = Rᵀ (constant in the world), N m.
    ConstantWorld {
        /// In world axes, N m.
        moment: Vector3<f64>,
    },
    /// τ = −c ω.
    LinearDamping {
        /// c, N m s, not negative.
        coefficient: f64,
    },
    /// τ = arm × F, force F constant in the body: a thruster.
    ForceBody {
        /// In principal axes, N.
        force: Vector3<f64>,
        /// Where it acts, in principal axes, m.
        arm: Vector3<f64>,
    },
    /// τ = arm × Rᵀ F, force F constant in the world. Gravity about a pivot is F = m g at the centre of mass.
    ForceWorld {
        /// In world axes, N.
        force: Vector3<f64>,
        /// Where it acts, in principal axes, m.
        arm: Vector3<f64>,
    },
    /// τ = 3 n² r × I r on a circular orbit in the world x-y plane, r = Rᵀ (cos nt, sin nt, 0).
    GravityGradient {
        /// n, rad/s.
        mean_motion: f64,
    },
}

/// A torque or force, and when it acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// What acts.
    pub torque: Torque,
    /// When.
    pub window: Window,
}
