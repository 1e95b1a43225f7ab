use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::recording::Axes;

/// How the numbers of a file are taken: what its columns may mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Whether the four columns said to be w, x, y, z are x, y, z, w.
    pub scalar_last: bool,
    /// Whether the quaternion takes world components to body components.
    pub body_from_world: bool,
    /// In which axes ω is.
    pub axes: Axes,
    /// What ω is multiplied by to be in rad/s.
    pub rate_factor: f64,
}

impl Reading {
    /// A factor of ω in degrees per second.
    pub const DEGREES: f64 = std::f64::consts::PI / 180.0;

    /// As polhode means a file that says no more: w, x, y, z, world from body, ω in rad/s.
    #[must_use]
    pub const fn plain(axes: Axes) -> Self {
        Self { scalar_last: false, body_from_world: false, axes, rate_factor: 1.0 }
    }

    /// In words: `q as w, x, y, z, world from body; ω in body axes`.
    #[must_use]
    pub fn words(&self) -> String {
        let order = if self.scalar_last { "x, y, z, w" } else { "w, x, y, z" };
        let way = if self.body_from_world { "body from world" } else { "world from body" };
        let axes = axes_name(self.axes);
        let unit = if self.rate_factor == Self::DEGREES {
            " in deg/s".to_owned()
        } else if self.rate_factor == 1.0 {
            String::new()
        } else {
            format!(" times {:.4}", self.rate_factor)
        };
        format!("q as {order}, {way}; ω in {axes} axes{unit}")
    }

    /// World from body, of the columns as they stand; `None` where they are no rotation.
    pub(super) fn attitude(&self, columns: [f64; 4]) -> Option<UnitQuaternion<f64>> {
        let [a, b, c, d] = columns;
        let q = if self.scalar_last { Quaternion::new(d, a, b, c) } else { Quaternion::new(a, b, c, d) };
        let unit = UnitQuaternion::try_new(q, 1e-150)?;
        Some(if self.body_from_world { unit.inverse() } else { unit })
    }

    /// ω in body axes, rad/s, of the columns as they stand.
    pub(super) fn rate(&self, columns: [f64; 3], attitude: &UnitQuaternion<f64>) -> Vector3<f64> {
        let rate = Vector3::from(columns) * self.rate_factor;
        match self.axes {
            Axes::Body => rate,
            Axes::World => attitude.inverse_transform_vector(&rate),
        }
    }
}

/// As tables say it.
#[must_use]
pub const fn axes_name(axes: Axes) -> &'static str {
    match axes {
        Axes::Body => "body",
        Axes::World => "world",
    }
}
