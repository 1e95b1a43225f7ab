/// What a recording, of whatever program, says of the motion of one body: each quantity at times of its own, values as
/// they stand in the file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Observed {
    /// As the file names the body: a frame, an entity, a topic; `body` where it does not.
    pub name: String,
    /// World from body, quaternion w, x, y, z, not normalised.
    pub attitude: Option<Track<4>>,
    /// rad/s.
    pub angular_velocity: Option<Track<3>>,
    /// N m s, about the reference point.
    pub angular_momentum: Option<Track<3>>,
    /// N m, about the reference point.
    pub moment: Option<Track<3>>,
    /// m, world axes.
    pub position: Option<Track<3>>,
    /// m/s.
    pub velocity: Option<Track<3>>,
}

/// One quantity over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Track<const N: usize> {
    /// When, s, ascending; from whatever start the file's clock has.
    pub times_s: Vec<f64>,
    /// Its components, each as long as the times.
    pub columns: [Vec<f64>; N],
    /// In which axes the file says it is; `None` where it does not say.
    pub axes: Option<Axes>,
    /// Half a unit in the last place of what the file keeps, relative to the largest of the values: 2⁻⁵³ of an f64, 2⁻²⁴
    /// of an f32, of a text what its digits show.
    pub resolution: f64,
}

/// The axes in which a vector is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Axes {
    /// Fixed in the body.
    Body,
    /// Fixed in the world.
    World,
}

impl Observed {
    /// Whether it tells any quantity.
    pub(super) fn tells(&self) -> bool {
        self.attitude.is_some() || self.vectors().any(|_| true)
    }

    /// Whether all values are finite.
    pub(super) fn is_finite(&self) -> bool {
        self.attitude.iter().all(Track::is_finite) && self.vectors().all(Track::is_finite)
    }

    fn vectors(&self) -> impl Iterator<Item = &Track<3>> {
        [&self.angular_velocity, &self.angular_momentum, &self.moment, &self.position, &self.velocity]
            .into_iter()
            .flatten()
    }
}

impl<const N: usize> Track<N> {
    fn is_finite(&self) -> bool {
        self.columns.iter().flatten().all(|value| value.is_finite())
    }
}
