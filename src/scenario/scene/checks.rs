#[cfg(feature = "serde")]
use serde::Deserialize;

/// What the motion must show, by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct Checks {
    /// Time from one flip to the next but one: the period of the polhode.
    pub flip_period: Vec<FlipPeriodSpec>,
    /// The energy law, at a thousand times over the duration.
    pub energy: Vec<DriftSpec>,
    /// The momentum law, at a thousand times over the duration.
    pub momentum: Vec<DriftSpec>,
    /// Mean rate at which an axis goes round.
    pub precession_rate: Vec<PrecessionRateSpec>,
    /// A channel's component at a time.
    pub value: Vec<ValueSpec>,
}

/// Period of the flips: of the principal component of ω that changes sign.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct FlipPeriodSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// s.
    pub expected_s: f64,
    /// s.
    pub tolerance_s: f64,
}

/// A conserved quantity.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct DriftSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// Largest relative change allowed.
    pub tolerance: f64,
}

/// Mean rate at which the body's axis goes round an axis of the world, or ω goes round an axis of the body.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct PrecessionRateSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// `world` (the default): the body axis goes round `around`, or round L. `body`: ω goes round the body axis.
    #[cfg_attr(feature = "serde", serde(default))]
    pub frame: Frame,
    /// The body's axis, in body axes.
    pub axis: [f64; 3],
    /// The world's axis, in world axes; left out: L at t = 0.
    #[cfg_attr(feature = "serde", serde(default))]
    pub around: Option<[f64; 3]>,
    /// Over which time the rate is averaged, s; left out: the duration.
    #[cfg_attr(feature = "serde", serde(default))]
    pub over_s: Option<f64>,
    /// rad/s.
    pub expected_rad_s: f64,
    /// rad/s.
    pub tolerance_rad_s: f64,
}

/// Which axes a check speaks of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
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
pub struct ValueSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The channel's name.
    pub channel: String,
    /// `w`, `x`, `y`, `z`; left out for a scalar.
    #[cfg_attr(feature = "serde", serde(default))]
    pub component: Option<String>,
    /// s.
    pub time_s: f64,
    /// In the channel's unit.
    pub expected: f64,
    /// In the channel's unit.
    pub tolerance: f64,
}
