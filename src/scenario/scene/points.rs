#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

use super::Frame;

/// A point of the body whose position, velocity and acceleration are recorded, as a body of the name `<body>/<name>` would.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ProbeSpec {
    /// Names its topics and entities with the body's: 1 to 64 letters, digits, `_` and `-`, unlike those of the body's other
    /// probes and IMUs.
    #[cfg_attr(feature = "schema", schemars(pattern(r"^[A-Za-z0-9_-]{1,64}$")))]
    pub name: String,
    /// Where it is, in body axes, from the body's origin, m.
    pub point_m: [f64; 3],
    /// The axes of the components recorded: of `position`, `velocity`, `acceleration`, or of `position_body`,
    /// `velocity_body`, `acceleration_body`; left out: `world`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub frame: Frame,
}

/// An inertial measurement unit: its `gyroscope` and `accelerometer` are recorded, as of a body of the name `<body>/<name>`.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ImuSpec {
    /// Names its topics and entities with the body's: 1 to 64 letters, digits, `_` and `-`, unlike those of the body's other
    /// probes and IMUs.
    #[cfg_attr(feature = "schema", schemars(pattern(r"^[A-Za-z0-9_-]{1,64}$")))]
    pub name: String,
    /// Where its accelerometer is, in body axes, from the body's origin, m.
    pub point_m: [f64; 3],
    /// Body from sensor, quaternion w, x, y, z, of length 1 within 1e-12; left out: `[1, 0, 0, 0]`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub attitude: Option<[f64; 4]>,
}
