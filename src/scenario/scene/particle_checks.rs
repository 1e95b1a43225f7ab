#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

/// Forces between particles that cancel.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct InternalForcesSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// How long they are looked at, s; left out: the duration.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub over_s: Option<f64>,
    /// Largest part of their sum without regard to direction that may be left.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance: f64,
}

/// How far particles on springs have turned from the rigid body of the same start.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct DepartureFromRigidSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// When, s.
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub time_s: f64,
    /// What the angle between the two attitudes must be, rad.
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub expected_rad: f64,
    /// How far off it may be, rad.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance_rad: f64,
}
