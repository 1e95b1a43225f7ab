#[cfg(feature = "serde")]
use serde::Deserialize;

use crate::recording::Axes;

/// What a recording of another program does not say of itself. Empty, it leaves all to the file.
///
/// A column is named as the header names it or, where no header does, by its number from 1 on. With feature `serde` it
/// is read from TOML, key by key as here; unknown keys are refused.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct Mapping {
    /// Of a table: what stands between its columns; left out: what its first line of numbers shows.
    pub separator: Option<Separator>,
    /// Of a table: whether its first line names the columns; left out: whether that line holds anything but numbers.
    pub header: Option<bool>,
    /// Of a table: the column of time; left out: `time_s`, `time` or `t`.
    pub time: Option<String>,
    /// Of a table: the unit of time.
    pub time_unit: TimeUnit,
    /// Of an `.mcap` or `.rrd`: the frame, topic or entity of the one body to be read; left out: all that move.
    pub frame: Option<String>,
    /// Of an `.mcap`: the frame that counts as fixed; left out: each body's parent.
    pub world: Option<String>,
    /// Of an `.rrd`: the timeline; left out: the only one of times.
    pub timeline: Option<String>,
    /// Of a table: its bodies; left out: one, with the columns whose names leave no doubt.
    pub body: Vec<BodyMapping>,
}

/// The columns of one body.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct BodyMapping {
    /// Its name; left out: `body`.
    pub name: Option<String>,
    /// Attitude as a quaternion: the columns of w, x, y, z, in this order, whatever theirs is.
    pub quaternion: Option<[String; 4]>,
    /// Attitude as modified Rodrigues parameters.
    pub mrp: Option<[String; 3]>,
    /// Attitude as a rotation matrix, row by row.
    pub matrix: Option<[String; 9]>,
    /// Attitude as three angles of turns about the body's axes, one after the other.
    pub euler_angles: Option<[String; 3]>,
    /// Those axes, the first turn first: `ZYX` for yaw, pitch, roll.
    pub euler_sequence: Option<String>,
    /// The unit of those angles.
    pub euler_unit: AngleUnit,
    /// Which way the attitude turns components.
    pub attitude_sense: Sense,
    /// ω.
    pub angular_velocity: Option<[String; 3]>,
    /// The axes of ω; left out: not known.
    pub angular_velocity_axes: Option<Axes>,
    /// The unit of ω.
    pub angular_velocity_unit: RateUnit,
    /// L, N m s, about the reference point.
    pub angular_momentum: Option<[String; 3]>,
    /// The axes of L; left out: not known.
    pub angular_momentum_axes: Option<Axes>,
    /// Moment, N m, about the reference point.
    pub moment: Option<[String; 3]>,
    /// The axes of the moment; left out: not known.
    pub moment_axes: Option<Axes>,
    /// Position, m, world axes.
    pub position: Option<[String; 3]>,
    /// Velocity, m/s.
    pub velocity: Option<[String; 3]>,
    /// The axes of the velocity; left out: not known.
    pub velocity_axes: Option<Axes>,
}

/// What stands between two columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
pub enum Separator {
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// One tab.
    Tab,
    /// Blanks and tabs, as many as there are.
    Blank,
}

/// Which way an attitude turns components of vectors.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
pub enum Sense {
    /// It makes world components of body components: `v_world = R v_body`, `q v_body q*`.
    #[default]
    WorldFromBody,
    /// It makes body components of world components.
    BodyFromWorld,
}

/// A unit of time.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize))]
pub enum TimeUnit {
    /// s
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "s"))]
    Second,
    /// ms
    #[cfg_attr(feature = "serde", serde(rename = "ms"))]
    Millisecond,
    /// µs
    #[cfg_attr(feature = "serde", serde(rename = "us"))]
    Microsecond,
    /// ns
    #[cfg_attr(feature = "serde", serde(rename = "ns"))]
    Nanosecond,
}

/// A unit of angles.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize))]
pub enum AngleUnit {
    /// rad
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "rad"))]
    Radian,
    /// deg
    #[cfg_attr(feature = "serde", serde(rename = "deg"))]
    Degree,
}

/// A unit of ω.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize))]
pub enum RateUnit {
    /// rad/s
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "rad/s"))]
    RadianPerSecond,
    /// deg/s
    #[cfg_attr(feature = "serde", serde(rename = "deg/s"))]
    DegreePerSecond,
    /// rpm
    #[cfg_attr(feature = "serde", serde(rename = "rpm"))]
    TurnPerMinute,
}

impl TimeUnit {
    /// 10 to the minus this, s.
    pub(super) const fn decimals(self) -> u32 {
        match self {
            Self::Second => 0,
            Self::Millisecond => 3,
            Self::Microsecond => 6,
            Self::Nanosecond => 9,
        }
    }
}

impl AngleUnit {
    /// In rad.
    pub(super) const fn in_rad(self) -> f64 {
        match self {
            Self::Radian => 1.0,
            Self::Degree => std::f64::consts::PI / 180.0,
        }
    }
}

impl RateUnit {
    /// In rad/s.
    pub(super) const fn in_rad_s(self) -> f64 {
        match self {
            Self::RadianPerSecond => 1.0,
            Self::DegreePerSecond => std::f64::consts::PI / 180.0,
            Self::TurnPerMinute => std::f64::consts::PI / 30.0,
        }
    }
}
