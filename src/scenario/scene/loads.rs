use std::path::PathBuf;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{
    BDotSpec, ForceFormulaSpec, Frame, InnerSphereSpec, QuadraticDampingSpec, QuadraticDragSpec,
    QuaternionFeedbackSpec, RateFeedbackSpec, SpringSpec, TorqueFormulaSpec,
};
use crate::dynamics::Interpolation;
#[cfg(feature = "schema")]
use crate::scenario::schema::structure;

macro_rules! windowed {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),+ $(,)? }) => {
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
        #[cfg_attr(feature = "schema", derive(JsonSchema))]
        $(#[$doc])*
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)+
            /// First instant at which it acts, s; left out: from the beginning.
            #[cfg_attr(feature = "serde", serde(default))]
            #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
            pub start_s: Option<f64>,
            /// First instant at which it no longer acts, s, after `start_s`; left out: to the end.
            #[cfg_attr(feature = "serde", serde(default))]
            #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
            pub end_s: Option<f64>,
        }
    };
}

pub(super) use windowed;

/// Torques by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct TorqueSpecs {
    /// Constant in body axes.
    pub constant_body: Vec<MomentSpec>,
    /// Constant in world axes.
    pub constant_world: Vec<MomentSpec>,
    /// τ = −c ω.
    pub linear_damping: Vec<DampingSpec>,
    /// τ = −c I ω: where nothing else acts, L keeps its direction and dies away.
    pub momentum_brake: Vec<BrakeSpec>,
    /// τ = m × B: a magnet in a uniform field, which does not pull.
    pub magnetic_dipole: Vec<MagneticDipoleSpec>,
    /// A moment as a function of time, from a table.
    pub table: Vec<TableSpec>,
    /// Circular orbit in the world x-y plane, from (1, 0, 0) at t = 0; not with a pivot.
    pub gravity_gradient: Vec<GravityGradientSpec>,
    /// A moment by formulae of time and motion.
    pub formula: Vec<TorqueFormulaSpec>,
    /// τ = −c |ω| ω.
    pub quadratic_damping: Vec<QuadraticDampingSpec>,
    /// A sphere in oil inside the body, which drags on it with c times its relative rate; at most one.
    pub inner_sphere: Vec<InnerSphereSpec>,
    /// About each body axis u = −k s e − d ω, e the vector part of the quaternion from the target, s the sign of its
    /// scalar part at t = 0, whenever it begins; through a dead band, and held within a limit.
    pub quaternion_feedback: Vec<QuaternionFeedbackSpec>,
    /// About each body axis −d ω, held within a limit.
    pub rate_feedback: Vec<RateFeedbackSpec>,
    /// Coils along the body axes, m = −k dB/dt, each held within a limit; τ = m × B.
    pub b_dot: Vec<BDotSpec>,
}

windowed! {
    /// A constant moment.
    MomentSpec {
        /// The moment, N m.
        moment_n_m: [f64; 3],
    }
}
windowed! {
    /// Damping in proportion to ω.
    DampingSpec {
        /// c, N m s.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        coefficient_n_m_s: f64,
    }
}
windowed! {
    /// A brake in proportion to L.
    BrakeSpec {
        /// c, 1/s.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        rate_per_s: f64,
    }
}
windowed! {
    /// A magnet in a uniform field: a compass needle, or what is left of a satellite's magnetism.
    MagneticDipoleSpec {
        /// m, in body axes, A m².
        dipole_a_m2: [f64; 3],
        /// B, in world axes, T.
        field_t: [f64; 3],
    }
}
windowed! {
    /// The gravity gradient's torque.
    GravityGradientSpec {
        /// n of the orbit, rad/s.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        mean_motion_rad_s: f64,
    }
}
windowed! {
    /// A force at a point of the body.
    ForceSpec {
        /// The force, N.
        force_n: [f64; 3],
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
    }
}

/// Forces by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ForceSpecs {
    /// A thruster: constant in body axes, at a point in body axes.
    pub constant_body: Vec<ForceSpec>,
    /// Constant in world axes, at a point in body axes.
    pub constant_world: Vec<ForceSpec>,
    /// Pulses of a force constant in body axes.
    pub thruster: Vec<ThrusterSpec>,
    /// A force as a function of time, from a table.
    pub table: Vec<TableSpec>,
    /// A force by formulae of time and motion.
    pub formula: Vec<ForceFormulaSpec>,
    /// A spring and a damper from a point of the world: F = −(k (ℓ − ℓ₀) + c dℓ/dt) along it.
    pub spring: Vec<SpringSpec>,
    /// F = −c |u| u at a point of the body that moves with u.
    pub quadratic_drag: Vec<QuadraticDragSpec>,
}

windowed! {
    /// A torque or a force as a function of time: from a file, or from rows.
    #[cfg_attr(feature = "schema", schemars(transform = structure::table))]
    TableSpec {
        /// CSV, relative to the scene: a header, then time in s and three components in N m, of a force in N; left out: the
        /// table is in `rows`.
        #[cfg_attr(feature = "serde", serde(default))]
        file: Option<PathBuf>,
        /// The same in the scene, `[t, x, y, z]`, times ascending; left out: the table is in `file`.
        #[cfg_attr(feature = "serde", serde(default))]
        rows: Option<Vec<[f64; 4]>>,
        /// The axes of its components.
        frame: Frame,
        /// What lies between the rows; left out: `linear`.
        #[cfg_attr(feature = "serde", serde(default))]
        interpolation: Interpolation,
        /// What comes after the last row; left out: `zero`.
        #[cfg_attr(feature = "serde", serde(default))]
        after: AfterTable,
        /// Of a force, which needs it: where it acts, in body axes, from the body's origin, m; left out: it is a moment.
        #[cfg_attr(feature = "serde", serde(default))]
        point_m: Option<[f64; 3]>,
    }
}

/// What a table says after its last row.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub enum AfterTable {
    /// Zero.
    #[default]
    Zero,
    /// The last row's values.
    Hold,
}

windowed! {
    /// A thruster that fires in pulses: listed, or periodic from `start_s` on.
    #[cfg_attr(feature = "schema", schemars(transform = structure::thruster))]
    ThrusterSpec {
        /// Direction of the force, in body axes, of length 1.
        direction: [f64; 3],
        /// Force at full level, N.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        thrust_n: f64,
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
        /// `[on, off]` or `[on, off, share]` of each: s, s, and the share of the full level; left out: it is periodic.
        #[cfg_attr(feature = "serde", serde(default))]
        #[cfg_attr(feature = "schema", schemars(transform = structure::pulses))]
        pulses_s: Option<Vec<Vec<f64>>>,
        /// From one pulse's start to the next's, s; left out: the pulses are listed.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        #[cfg_attr(feature = "serde", serde(default))]
        period_s: Option<f64>,
        /// Share of the period for which it fires; left out: the pulses are listed.
        #[cfg_attr(feature = "schema", schemars(range(max = 1), extend("exclusiveMinimum" = 0)))]
        #[cfg_attr(feature = "serde", serde(default))]
        duty: Option<f64>,
    }
}

/// A wheel that spins inside the body, its momentum relative to the body constant or by straight lines.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(transform = structure::rotor))]
pub struct RotorSpec {
    /// Along which its momentum is, in body axes, of length 1.
    pub axis: [f64; 3],
    /// Momentum relative to the body, constant, N m s: the motor holds the wheel at its speed; left out: it is scheduled.
    #[cfg_attr(feature = "serde", serde(default))]
    pub momentum_n_m_s: Option<f64>,
    /// Times of scheduled momenta, s, ascending; left out: the momentum is constant.
    #[cfg_attr(feature = "serde", serde(default))]
    pub times_s: Option<Vec<f64>>,
    /// Momenta at these times, N m s, by straight lines, constant before and after; left out: the momentum is constant.
    #[cfg_attr(feature = "serde", serde(default))]
    pub momenta_n_m_s: Option<Vec<f64>>,
}
