use super::error::ToleranceError;
use crate::telemetry::Channel;

/// How far apart two values of a channel may be and count as the same: `absolute + relative × size`, where the size is the
/// largest of the channel over all samples compared.
///
/// An attitude is measured by an angle in rad, and its size is 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    absolute: f64,
    relative: f64,
}

/// By what a channel is judged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// Every bit the same.
    Exact,
    /// No further apart than this.
    Within(Tolerance),
    /// Measured, not judged.
    Shown,
}

/// The rule of every channel.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerances {
    rules: [Rule; Channel::ALL.len()],
}

impl Tolerance {
    /// What is meant by "the same" where nothing else is said: far above the roundings of this crate's methods, far below
    /// what can be seen.
    const DEFAULT: f64 = 1e-9;
    /// In the channel's SI unit: so that where a channel is nothing but roundings of zero these are no difference.
    const OF_ZERO: f64 = 1e-15;

    /// In the channel's unit, and of its largest size.
    ///
    /// # Errors
    /// If one of them is negative or no finite number.
    pub fn new(absolute: f64, relative: f64) -> Result<Self, ToleranceError> {
        let is_none = |value: &f64| !(0.0..f64::INFINITY).contains(value);
        match [absolute, relative].into_iter().find(is_none) {
            Some(value) => Err(ToleranceError::Number { value }),
            None => Ok(Self { absolute, relative }),
        }
    }

    /// In the unit of the channel; of an attitude, rad.
    #[must_use]
    pub const fn absolute(self) -> f64 {
        self.absolute
    }

    /// Of the channel's largest size.
    #[must_use]
    pub const fn relative(self) -> f64 {
        self.relative
    }

    /// The largest difference between values of a channel that gets as large as `size`.
    #[must_use]
    pub fn limit(self, size: f64) -> f64 {
        // What has no size has no share of it.
        self.absolute + if self.relative > 0.0 { self.relative * size } else { 0.0 }
    }
}

impl Tolerances {
    /// Every bit of every channel.
    #[must_use]
    pub const fn exact() -> Self {
        Self { rules: [Rule::Exact; Channel::ALL.len()] }
    }

    /// The rule of `channel`.
    #[must_use]
    pub const fn of(&self, channel: Channel) -> Rule {
        self.rules[channel as usize]
    }

    /// The same with another rule for `channel`.
    #[must_use]
    pub const fn with(mut self, channel: Channel, rule: Rule) -> Self {
        self.rules[channel as usize] = rule;
        self
    }

    /// Whether nothing but bits counts.
    #[must_use]
    pub fn are_exact(&self) -> bool {
        self.rules.iter().all(|rule| *rule == Rule::Exact)
    }
}

impl Default for Tolerances {
    /// 1e-9 rad between attitudes, tilts and angles that come round, 1e-9 of the largest size of everything else. Drifts and slip are roundings of
    /// what computed them: they are shown, not judged.
    fn default() -> Self {
        let rule = |channel| match channel {
            Channel::EnergyDrift | Channel::MomentumDrift | Channel::Slip => Rule::Shown,
            Channel::Attitude | Channel::Tilt | Channel::MomentumTilt => {
                Rule::Within(Tolerance { absolute: Tolerance::DEFAULT, relative: 0.0 })
            }
            angles if angles.comes_round() => Rule::Within(Tolerance { absolute: Tolerance::DEFAULT, relative: 0.0 }),
            _ => Rule::Within(Tolerance { absolute: Tolerance::OF_ZERO, relative: Tolerance::DEFAULT }),
        };
        Self { rules: Channel::ALL.map(rule) }
    }
}
