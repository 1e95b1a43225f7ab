/// How far a simulation may be from a golden.
///
/// ```
/// use polhode::golden::Limits;
///
/// let limits = Limits::attitude(1e-6).angular_velocity(1e-5).until(2.0);
/// # assert_eq!(limits, Limits::attitude(1e-6).until(2.0).angular_velocity(1e-5));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    pub(super) attitude_rad: Option<f64>,
    pub(super) angular_velocity_rad_s: Option<f64>,
    pub(super) until_s: f64,
}

impl Limits {
    /// The angle between the attitudes is at most `rad`.
    #[must_use]
    pub const fn attitude(rad: f64) -> Self {
        Self { attitude_rad: Some(rad), ..Self::none() }
    }

    /// Whatever it is, it is reported and no error: to see how far a simulation is off.
    #[must_use]
    pub const fn none() -> Self {
        Self { attitude_rad: None, angular_velocity_rad_s: None, until_s: f64::INFINITY }
    }

    /// And the difference between the angular velocities, a vector, is at most `rad_s` long, rad/s. A pose that does not say
    /// how it turns is then out of the limit.
    #[must_use]
    pub const fn angular_velocity(self, rad_s: f64) -> Self {
        Self { angular_velocity_rad_s: Some(rad_s), ..self }
    }

    /// Up to this time, s: later samples are not asked for.
    #[must_use]
    pub const fn until(self, time_s: f64) -> Self {
        Self { until_s: time_s, ..self }
    }
}
