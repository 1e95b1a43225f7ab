#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

/// What was observed of a real body, in the unit of the check that has it: the residual is told, and judged only if there
/// is a tolerance.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ObservedSpec {
    /// The published value.
    pub published: f64,
    /// Its uncertainty as published.
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub uncertainty: f64,
    /// How far from it the model may be; left out: it is not judged.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance: Option<f64>,
}

/// Whether a body axis stays near a direction.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct StabilitySpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The body's axis, in body axes, of length 1.
    pub axis: [f64; 3],
    /// The direction, in world axes, of length 1; left out: where the axis points at t = 0.
    #[cfg_attr(feature = "serde", serde(default))]
    pub near: Option<[f64; 3]>,
    /// How long it is looked at, s; left out: the duration.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub over_s: Option<f64>,
    /// How far off the axis may be, or must come to be, rad.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = std::f64::consts::PI)))]
    pub angle_rad: f64,
    /// What must be found.
    pub verdict: Verdict,
}

/// What becomes of an axis.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub enum Verdict {
    /// Never further off than the angle.
    #[default]
    Stays,
    /// Further off at some time.
    Leaves,
}

/// Montgomery's phase: how far a free body has turned about L when ω is back where it was in the body.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct MontgomeryPhaseSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The period in which ω comes back, s, as far as it must be known to find it: within a third.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub period_s: f64,
    /// What the angle must be, rad; whole turns count for nothing.
    pub expected_rad: f64,
    /// How far off it may be, rad.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance_rad: f64,
}
