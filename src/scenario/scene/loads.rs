#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

macro_rules! windowed {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
        #[cfg_attr(feature = "schema", derive(JsonSchema))]
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
    /// τ = −c L: L keeps its direction and dies away.
    pub momentum_brake: Vec<BrakeSpec>,
    /// Circular orbit in the world x-y plane, from (1, 0, 0) at t = 0; not with a pivot.
    pub gravity_gradient: Vec<GravityGradientSpec>,
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
}
