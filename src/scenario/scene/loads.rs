#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{
    BDotSpec, ForceFormulaSpec, InnerSphereSpec, QuadraticDampingSpec, QuadraticDragSpec, QuaternionFeedbackSpec,
    RateFeedbackSpec, SpringSpec, TorqueFormulaSpec,
};

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
    /// By formulae of time and motion.
    pub formula: Vec<ForceFormulaSpec>,
    /// From a point of the world.
    pub spring: Vec<SpringSpec>,
    /// F = −c |u| u.
    pub quadratic_drag: Vec<QuadraticDragSpec>,
}
