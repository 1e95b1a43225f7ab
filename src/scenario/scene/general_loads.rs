#[cfg(feature = "serde")]
use serde::Deserialize;

use super::Frame;
use super::loads::windowed;

windowed! {
    /// A moment by formulae of time and motion.
    TorqueFormulaSpec {
        /// x, y and z, N m, each as text.
        moment_n_m: [String; 3],
        /// The axes of the components.
        frame: Frame,
    }
}
windowed! {
    /// A force by formulae of time and motion.
    ForceFormulaSpec {
        /// x, y and z, N, each as text.
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
        /// c, N m s², not negative.
        coefficient_n_m_s2: f64,
    }
}
windowed! {
    /// F = −c |u| u at a point of the body that moves with u.
    QuadraticDragSpec {
        /// c, kg/m, not negative.
        coefficient_kg_m: f64,
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
    }
}
windowed! {
    /// A spring and a damper from the world to a point of the body.
    SpringSpec {
        /// World axes, m.
        anchor_m: [f64; 3],
        /// In body axes, from the body's origin, m.
        point_m: [f64; 3],
        /// k, N/m, positive.
        stiffness_n_m: f64,
        /// Not negative, m.
        rest_length_m: f64,
        /// c, N s/m, not negative; left out: none.
        #[cfg_attr(feature = "serde", serde(default))]
        damping_n_s_m: Option<f64>,
        /// Whether it only pulls; then it has no damper. Left out: it pushes as well.
        #[cfg_attr(feature = "serde", serde(default))]
        pulls_only: bool,
    }
}
windowed! {
    /// Feedback of attitude and rates, through a dead band and a limit.
    QuaternionFeedbackSpec {
        /// World from body, quaternion w, x, y, z.
        target: [f64; 4],
        /// k of −k e, e the vector part of the quaternion from the target, N m, not negative.
        attitude_gain_n_m: f64,
        /// d of −d ω, N m s, not negative.
        rate_gain_n_m_s: f64,
        /// Largest moment about each body axis, N m; left out: none.
        #[cfg_attr(feature = "serde", serde(default))]
        limit_n_m: Option<f64>,
        /// What is taken off each component, N m; left out: nothing.
        #[cfg_attr(feature = "serde", serde(default))]
        dead_band_n_m: Option<f64>,
    }
}
windowed! {
    /// Feedback of rates, with a limit.
    RateFeedbackSpec {
        /// d of −d ω, N m s, not negative.
        gain_n_m_s: f64,
        /// Largest moment about each body axis, N m; left out: none.
        #[cfg_attr(feature = "serde", serde(default))]
        limit_n_m: Option<f64>,
    }
}
windowed! {
    /// Coils against the change of a magnetic field.
    BDotSpec {
        /// B at t = 0, world axes, T.
        field_t: [f64; 3],
        /// How the field turns in the world, world axes, rad/s; left out: it stands still.
        #[cfg_attr(feature = "serde", serde(default))]
        field_turning_rad_s: Option<[f64; 3]>,
        /// k of m = −k dB/dt, A m² s/T, not negative.
        gain_a_m2_s_t: f64,
        /// Largest moment of the coil along each body axis, A m²; left out: none.
        #[cfg_attr(feature = "serde", serde(default))]
        limit_a_m2: Option<f64>,
    }
}

/// A sphere in a film of fluid inside the body.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct InnerSphereSpec {
    /// J, kg m²: part of the body's, below each of its moments.
    pub inertia_kg_m2: f64,
    /// c of the moment c σ with which it drags on the body, N m s, not negative.
    pub coefficient_n_m_s: f64,
    /// σ at t = 0: its rates relative to the body, body axes, rad/s; left out: none.
    #[cfg_attr(feature = "serde", serde(default))]
    pub relative_rate_rad_s: Option<[f64; 3]>,
}
