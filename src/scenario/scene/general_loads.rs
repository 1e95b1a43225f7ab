#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

use super::Frame;
use super::loads::windowed;

windowed! {
    /// A moment by formulae of time and motion.
    TorqueFormulaSpec {
        /// Formulae of x, y and z, N m.
        moment_n_m: [String; 3],
        /// The axes of the components.
        frame: Frame,
    }
}
windowed! {
    /// A force by formulae of time and motion.
    ForceFormulaSpec {
        /// Formulae of x, y and z, N.
        force_n: [String; 3],
        /// The axes of the components.
        frame: Frame,
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
    }
}
windowed! {
    /// τ = −c |ω| ω.
    QuadraticDampingSpec {
        /// c, N m s².
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        coefficient_n_m_s2: f64,
    }
}
windowed! {
    /// F = −c |u| u at a point of the body that moves with u.
    QuadraticDragSpec {
        /// c, kg/m.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        coefficient_kg_per_m: f64,
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
    }
}
windowed! {
    /// A spring and a damper from the world to a point of the body.
    SpringSpec {
        /// Its end in the world, world axes, m.
        anchor_m: [f64; 3],
        /// Its end on the body, in body axes, from the body's origin, m.
        point_m: [f64; 3],
        /// k, N/m.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        stiffness_n_per_m: f64,
        /// ℓ₀, m.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        rest_length_m: f64,
        /// c, N s/m; left out: `0`.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        #[cfg_attr(feature = "serde", serde(default))]
        damping_n_s_per_m: Option<f64>,
        /// Whether it only pulls, as a tether does, and has no damper; left out: `false`.
        #[cfg_attr(feature = "serde", serde(default))]
        pulls_only: bool,
    }
}
windowed! {
    /// Feedback of attitude and rates, through a dead band and a limit.
    QuaternionFeedbackSpec {
        /// World from body, quaternion w, x, y, z, of length 1 within 1e-12.
        target: [f64; 4],
        /// k, N m.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        attitude_gain_n_m: f64,
        /// d, N m s.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        rate_gain_n_m_s: f64,
        /// Largest moment about each body axis, N m; left out: none.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        #[cfg_attr(feature = "serde", serde(default))]
        limit_n_m: Option<f64>,
        /// What is taken off each component, N m; left out: `0`.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        #[cfg_attr(feature = "serde", serde(default))]
        dead_band_n_m: Option<f64>,
    }
}
windowed! {
    /// Feedback of rates, with a limit.
    RateFeedbackSpec {
        /// d, N m s.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        gain_n_m_s: f64,
        /// Largest moment about each body axis, N m; left out: none.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        #[cfg_attr(feature = "serde", serde(default))]
        limit_n_m: Option<f64>,
    }
}
windowed! {
    /// Coils against the change of a magnetic field.
    BDotSpec {
        /// B at t = 0, world axes, T.
        field_t: [f64; 3],
        /// How the field turns in the world, world axes, rad/s; left out: zero.
        #[cfg_attr(feature = "serde", serde(default))]
        field_turning_rad_s: Option<[f64; 3]>,
        /// k, A m² s/T.
        #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
        gain_a_m2_s_per_t: f64,
        /// Largest moment of the coil along each body axis, A m²; left out: none.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        #[cfg_attr(feature = "serde", serde(default))]
        limit_a_m2: Option<f64>,
    }
}

/// A sphere in a film of fluid inside the body.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct InnerSphereSpec {
    /// J, kg m²: part of the body's, below each of its moments.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub inertia_kg_m2: f64,
    /// c, N m s.
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub coefficient_n_m_s: f64,
    /// Its rates relative to the body at t = 0, body axes, rad/s; left out: zero.
    #[cfg_attr(feature = "serde", serde(default))]
    pub relative_rate_rad_s: Option<[f64; 3]>,
}
