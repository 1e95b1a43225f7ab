//! What a run looks like, decided once for all picture formats: scales, colours, camera, rate.

pub(super) mod camera;
mod cord;
pub(super) mod pace;
mod poinsot;
mod powers;
mod preview;
pub(super) mod scale;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::telemetry::{BodySamples, Channel};

pub use cord::Cord;
pub use poinsot::Poinsot;

/// How to draw a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Every how many samples the moving parts are drawn: at most 60 pictures in a second of playback, unless a body turns
    /// so fast that it takes more to follow it.
    pub stride: u64,
    /// Seconds of motion in a second of playback.
    pub playback_speed: f64,
    /// Number of the run's last sample, which is drawn whatever the stride.
    pub last: u64,
    /// Where the camera stands, world axes, m.
    pub eye: Vector3<f64>,
    /// What it looks at, world axes, m.
    pub target: Vector3<f64>,
    /// z of the ground, so that the eye knows up from down, m: below every body, and at the tip of one that stands on a
    /// pivot.
    pub floor: f64,
    /// Extent of the largest body, m: arrows and axes are as large at every body.
    pub size: f64,
    /// The bodies, in the plan's order.
    pub bodies: Vec<BodyPicture>,
    /// Channels whose numbers are too large or too small for an axis: their plots are in 10ⁿ of the unit.
    pub powers: Vec<(Channel, i32)>,
}

/// How to draw one body.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyPicture {
    /// Of its surfaces: red, green, blue, opacity.
    pub colour: [u8; 4],
    /// Radius of the sphere about the reference point that holds the body, m.
    pub extent: f64,
    /// Vectors drawn from the reference point.
    pub arrows: Vec<Arrow>,
    /// The body's direction that the trail follows, unit, in body axes: the principal axis nearest to ω at t = 0.
    pub spin_axis: Vector3<f64>,
    /// Of the reference point, at every sample; where it does not move.
    pub position: Vector3<f64>,
    /// Whether the reference point goes so far that the body is small in the picture of all its way.
    pub travels: bool,
    /// The springs that hold it.
    pub cords: Vec<Cord>,
    /// Its rolling ellipsoid, if it turns freely and what is recorded tells how.
    pub poinsot: Option<Poinsot>,
}

/// One vector as an arrow.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrow {
    /// Which.
    pub quantity: Quantity,
    /// Symbol and scale: `ω (1 m = 5 rad/s)`.
    pub label: String,
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// Length per unit of the quantity, m.
    pub metres_per_unit: f64,
}

/// A vector that can be drawn as an arrow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// ω.
    AngularVelocity,
    /// L.
    AngularMomentum,
    /// τ.
    Moment,
    /// F.
    Force,
}

impl Quantity {
    /// Symbol, unit and name in entity paths.
    #[must_use]
    pub const fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::AngularVelocity => ("ω", "rad/s", "angular_velocity"),
            Self::AngularMomentum => ("L", "N m s", "angular_momentum"),
            Self::Moment => ("τ", "N m", "moment"),
            Self::Force => ("F", "N", "force"),
        }
    }

    /// Its channel in world axes, and the one in body axes.
    #[must_use]
    pub const fn channels(self) -> (Channel, Option<Channel>) {
        match self {
            Self::AngularVelocity => (Channel::AngularVelocityWorld, Some(Channel::AngularVelocity)),
            Self::AngularMomentum => (Channel::AngularMomentumWorld, Some(Channel::AngularMomentumBody)),
            Self::Moment => (Channel::MomentWorld, Some(Channel::MomentBody)),
            Self::Force => (Channel::ForceWorld, None),
        }
    }

    /// Whether these channels say where it points in the world.
    #[must_use]
    pub fn is_recorded(self, channels: &[Channel]) -> bool {
        let (world, body) = self.channels();
        let turned = |body| channels.contains(&body) && channels.contains(&Channel::Attitude);
        channels.contains(&world) || body.is_some_and(turned)
    }

    /// World components at sample `index` from whichever channel is there.
    #[must_use]
    pub fn in_world(self, samples: &BodySamples, index: usize) -> Option<Vector3<f64>> {
        let (world, body) = self.channels();
        if let Some(columns) = samples.channel(world) {
            return Some(vector(columns, index));
        }
        let in_body = vector(samples.channel(body?)?, index);
        Some(attitude(samples, index)? * in_body)
    }
}

/// World from body at sample `index`.
#[must_use]
pub fn attitude(samples: &BodySamples, index: usize) -> Option<UnitQuaternion<f64>> {
    let [w, x, y, z] = samples.channel(Channel::Attitude)? else { return None };
    Some(UnitQuaternion::new_unchecked(Quaternion::new(w[index], x[index], y[index], z[index])))
}

/// A vector channel's value at sample `index`.
pub(super) fn vector(columns: &[Vec<f64>], index: usize) -> Vector3<f64> {
    Vector3::from_fn(|row, _| columns[row][index])
}

impl Picture {
    /// The power of ten that plots of `channel` count its unit in; 0 where its numbers are handy.
    #[must_use]
    pub fn power(&self, channel: Channel) -> i32 {
        self.powers.iter().find(|(scaled, _)| *scaled == channel).map_or(0, |(_, power)| *power)
    }

    /// Whether sample `index` of the run is drawn.
    #[must_use]
    pub const fn draws(&self, index: u64) -> bool {
        index.is_multiple_of(self.stride) || index == self.last
    }
}
