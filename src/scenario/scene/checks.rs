#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{
    ConservedSpec, DepartureFromRigidSpec, ExtremumSpec, InternalForcesSpec, MontgomeryPhaseSpec, ObservedSpec,
    PeriodSpec, RateSpec, StabilitySpec,
};
#[cfg(feature = "schema")]
use crate::scenario::schema::structure;

/// What the motion must show, by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct Checks {
    /// Twice the time between sign changes of ω along the middle principal axis: the period of the polhode.
    pub flip_period: Vec<FlipPeriodSpec>,
    /// Largest relative change of the energy at a thousand times over the duration; where a law holds.
    pub energy: Vec<DriftSpec>,
    /// Largest relative departure of L from its law at a thousand times over the duration; where a law holds.
    pub momentum: Vec<DriftSpec>,
    /// Mean rate at which the body's axis goes round an axis of the world, or ω round an axis of the body.
    pub precession_rate: Vec<PrecessionRateSpec>,
    /// A component of a channel at a time. The quaternion's sign is continuous from the start.
    pub value: Vec<ValueSpec>,
    /// Time from one upward crossing of `level` to the next, located on the motion; of an angle that comes round, a turn.
    pub period: Vec<PeriodSpec>,
    /// Mean rate of an angle that comes round, whole turns counted.
    pub rate: Vec<RateSpec>,
    /// Least or greatest value of a component in a span of time, located on the motion.
    pub extremum: Vec<ExtremumSpec>,
    /// Largest change of a component at a thousand times over the duration, relative to its largest magnitude.
    pub conserved: Vec<ConservedSpec>,
    /// Largest angle between the body's `axis` and `near` at 4096 times: `stays` is met up to `angle_rad`, `leaves` from
    /// it on.
    pub stability: Vec<StabilitySpec>,
    /// Angle that a free body of three different moments turns about L in a period of ω in the body.
    pub montgomery_phase: Vec<MontgomeryPhaseSpec>,
    /// What is left of the forces of springs between particles, and of their moments, when all are added: the largest part at a
    /// thousand times.
    pub internal_forces: Vec<InternalForcesSpec>,
    /// Angle between the attitude of particles on springs and that of the rigid body of the same start.
    pub departure_from_rigid: Vec<DepartureFromRigidSpec>,
}

/// Period of the flips: of the principal component of ω that changes sign.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct FlipPeriodSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
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

/// A conserved quantity.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct DriftSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// Largest relative change allowed.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance: f64,
}

/// Mean rate at which the body's axis goes round an axis of the world, or ω goes round an axis of the body.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct PrecessionRateSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// `world`: the body's `axis` goes round `around`. `body`: ω goes round `axis`; left out: `world`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub frame: Frame,
    /// The body's axis, in body axes, of length 1.
    pub axis: [f64; 3],
    /// The world's axis, in world axes, of length 1; left out: L at t = 0.
    #[cfg_attr(feature = "serde", serde(default))]
    pub around: Option<[f64; 3]>,
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

/// Which axes a check speaks of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub enum Frame {
    /// Inertial axes.
    #[default]
    World,
    /// Axes fixed in the body.
    Body,
}

/// One component of one channel at one time.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ValueSpec {
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
    /// When, s.
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub time_s: f64,
    /// What it must be, in the channel's unit.
    pub expected: f64,
    /// How far off it may be, in the channel's unit.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub tolerance: f64,
}
