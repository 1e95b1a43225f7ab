use std::path::PathBuf;

#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{
    BDotSpec, ForceFormulaSpec, Frame, InnerSphereSpec, QuadraticDampingSpec, QuadraticDragSpec,
    QuaternionFeedbackSpec, RateFeedbackSpec, SpringSpec, TorqueFormulaSpec,
};
use crate::dynamics::Interpolation;

macro_rules! windowed {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)+
            /// First instant at which it acts, s; left out: from the beginning.
            #[cfg_attr(feature = "serde", serde(default))]
            pub start_s: Option<f64>,
            /// First instant at which it no longer acts, s; left out: to the end.
            #[cfg_attr(feature = "serde", serde(default))]
            pub end_s: Option<f64>,
        }
    };
}

pub(super) use windowed;

/// Torques by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct TorqueSpecs {
    /// Constant in body axes.
    pub constant_body: Vec<MomentSpec>,
    /// Constant in world axes.
    pub constant_world: Vec<MomentSpec>,
    /// τ = −c ω.
    pub linear_damping: Vec<DampingSpec>,
    /// τ = −c L.
    pub momentum_brake: Vec<BrakeSpec>,
    /// τ = m × Rᵀ B.
    pub magnetic_dipole: Vec<MagneticDipoleSpec>,
    /// A function of time, by a table.
    pub table: Vec<TableSpec>,
    /// On a circular orbit in the world x-y plane, from (1, 0, 0) at t = 0.
    pub gravity_gradient: Vec<GravityGradientSpec>,
    /// By formulae of time and motion.
    pub formula: Vec<TorqueFormulaSpec>,
    /// τ = −c |ω| ω.
    pub quadratic_damping: Vec<QuadraticDampingSpec>,
    /// By a sphere inside the body; at most one.
    pub inner_sphere: Vec<InnerSphereSpec>,
    /// Towards a target attitude.
    pub quaternion_feedback: Vec<QuaternionFeedbackSpec>,
    /// Against ω.
    pub rate_feedback: Vec<RateFeedbackSpec>,
    /// Against the change of a magnetic field.
    pub b_dot: Vec<BDotSpec>,
}

windowed! {
    /// A constant moment.
    MomentSpec {
        /// N m.
        moment_n_m: [f64; 3],
    }
}
windowed! {
    /// Damping in proportion to ω.
    DampingSpec {
        /// c, N m s, not negative.
        coefficient_n_m_s: f64,
    }
}
windowed! {
    /// A brake in proportion to L.
    BrakeSpec {
        /// c, 1/s, not negative.
        rate_per_s: f64,
    }
}
windowed! {
    /// A magnet in a uniform field: a compass needle, or what is left of a satellite's magnetism.
    MagneticDipoleSpec {
        /// In body axes, A m².
        dipole_a_m2: [f64; 3],
        /// In world axes, T.
        field_t: [f64; 3],
    }
}
windowed! {
    /// The gravity gradient's torque.
    GravityGradientSpec {
        /// n, rad/s, of the orbit.
        mean_motion_rad_s: f64,
    }
}
windowed! {
    /// A force at a point of the body.
    ForceSpec {
        /// N.
        force_n: [f64; 3],
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
    }
}

/// Forces by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct ForceSpecs {
    /// Constant in body axes: a thruster.
    pub constant_body: Vec<ForceSpec>,
    /// Constant in world axes.
    pub constant_world: Vec<ForceSpec>,
    /// Pulses of a force constant in body axes.
    pub thruster: Vec<ThrusterSpec>,
    /// A function of time, by a table.
    pub table: Vec<TableSpec>,
    /// By formulae of time and motion.
    pub formula: Vec<ForceFormulaSpec>,
    /// From a point of the world.
    pub spring: Vec<SpringSpec>,
    /// F = −c |u| u.
    pub quadratic_drag: Vec<QuadraticDragSpec>,
}

windowed! {
    /// A torque or a force as a function of time: from a file, or from rows.
    TableSpec {
        /// CSV: a header of four columns, then time in s and three components in N m, of a force in N; relative to the
        /// scene.
        #[cfg_attr(feature = "serde", serde(default))]
        file: Option<PathBuf>,
        /// The same in the scene: `[t, x, y, z]`, ascending.
        #[cfg_attr(feature = "serde", serde(default))]
        rows: Option<Vec<[f64; 4]>>,
        /// The axes of its components.
        frame: Frame,
        /// What lies between the rows; left out: straight lines.
        #[cfg_attr(feature = "serde", serde(default))]
        interpolation: Interpolation,
        /// What comes after the last row; left out: nothing.
        #[cfg_attr(feature = "serde", serde(default))]
        after: AfterTable,
        /// Of a force: where it acts, in body axes, from the body's origin, m.
        #[cfg_attr(feature = "serde", serde(default))]
        point_m: Option<[f64; 3]>,
    }
}

/// What a table says after its last row.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
pub enum AfterTable {
    /// Zero.
    #[default]
    Zero,
    /// The last row's values.
    Hold,
}

windowed! {
    /// A thruster that fires in pulses: listed, or periodic from `start_s` on.
    ThrusterSpec {
        /// Of the force, in body axes, of length 1.
        direction: [f64; 3],
        /// Force at full level, N.
        thrust_n: f64,
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
        /// `[on, off]` or `[on, off, amplitude]`: s, s, share of the full level.
        #[cfg_attr(feature = "serde", serde(default))]
        pulses_s: Option<Vec<Vec<f64>>>,
        /// From one pulse's start to the next's, s.
        #[cfg_attr(feature = "serde", serde(default))]
        period_s: Option<f64>,
        /// Share of the period for which it fires, up to 1.
        #[cfg_attr(feature = "serde", serde(default))]
        duty: Option<f64>,
    }
}

/// A wheel that spins inside the body, its momentum relative to the body constant or by straight lines.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct RotorSpec {
    /// In body axes, of length 1.
    pub axis: [f64; 3],
    /// Constant momentum, N m s.
    #[cfg_attr(feature = "serde", serde(default))]
    pub momentum_n_m_s: Option<f64>,
    /// Times of the momenta, s, ascending.
    #[cfg_attr(feature = "serde", serde(default))]
    pub times_s: Option<Vec<f64>>,
    /// Momentum at these times, N m s; constant before the first and after the last.
    #[cfg_attr(feature = "serde", serde(default))]
    pub momenta_n_m_s: Option<Vec<f64>>,
}
