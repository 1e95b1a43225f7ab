#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

use super::ObservedSpec;
#[cfg(feature = "schema")]
use crate::scenario::schema::structure;

/// Period of a component: time between upward crossings of a level, located on the motion.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct PeriodSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The channel's name.
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::channel"))]
    pub channel: String,
    /// Which component; left out: the channel is a scalar.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::component"))]
    pub component: Option<String>,
    /// What is crossed, in the channel's unit; of an angle that comes round, where its turns are counted; left out: `0`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub level: Option<f64>,
    /// Over how many periods the mean is taken; left out: `1`.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = 1000)))]
    pub cycles: Option<u16>,
    /// What the period must be, s.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub expected_s: f64,
    /// How far off it may be, s.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance_s: f64,
    /// What the world says, s.
    #[cfg_attr(feature = "serde", serde(default))]
    pub observed: Option<ObservedSpec>,
}

/// Mean rate of a component of a channel of angles that come round: whole turns counted.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct RateSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The channel's name.
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::channel"))]
    pub channel: String,
    /// Which component; left out: the channel is a scalar.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::component"))]
    pub component: Option<String>,
    /// Over which time the rate is averaged, s; left out: the duration.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub over_s: Option<f64>,
    /// What the rate must be, rad/s.
    pub expected_rad_s: f64,
    /// How far off it may be, rad/s.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance_rad_s: f64,
    /// What the world says, rad/s.
    #[cfg_attr(feature = "serde", serde(default))]
    pub observed: Option<ObservedSpec>,
}

/// Least or greatest value of a component in a span of time, located on the motion.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ExtremumSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The channel's name.
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::channel"))]
    pub channel: String,
    /// Which component; left out: the channel is a scalar.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::component"))]
    pub component: Option<String>,
    /// Which of the two.
    pub extremum: Extremum,
    /// From when, s; left out: `0`.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub from_s: Option<f64>,
    /// Until when, s; left out: the duration.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub to_s: Option<f64>,
    /// What it must be, in the channel's unit.
    pub expected: f64,
    /// How far off it may be, in the channel's unit.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance: f64,
}

/// Which end of a range.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub enum Extremum {
    /// The lowest value.
    Least,
    /// The highest value.
    #[default]
    Greatest,
}

/// A component that keeps its value.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ConservedSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The channel's name.
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::channel"))]
    pub channel: String,
    /// Which component; left out: the channel is a scalar.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::component"))]
    pub component: Option<String>,
    /// Largest change allowed, relative to the largest magnitude.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance: f64,
}
