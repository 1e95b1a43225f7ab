/// How far the motion of one body, as it is recorded, is from the exact motion of the same numbers: measured at some of
/// the run's own samples, by a path of its own in higher precision.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// Largest angle between recorded and exact attitude, rad; `None` where no attitude is propagated.
    pub attitude_rad: Option<f64>,
    /// Largest difference in ω, relative to the largest ω.
    pub angular_velocity_relative: f64,
    /// Largest difference in L in world axes, relative to the largest L; `None` where no attitude is propagated.
    pub angular_momentum_relative: Option<f64>,
    /// Largest distance between recorded and exact reference point, m; `None` where no translation is propagated.
    pub position_m: Option<f64>,
    /// Where the attitude is worst (ω, where there is no attitude), s.
    pub worst_at_s: f64,
    /// Until when the motion was compared, s: the last sample, or less where the reference took too long or lost its digits.
    pub covered_to_s: f64,
    /// Whether that is the whole run.
    pub is_whole: bool,
    /// How many samples were compared, the first and the last of those covered among them.
    pub samples: usize,
    /// What is certified: the body's path.
    pub method: String,
    /// What it was compared with.
    pub reference: String,
    /// Largest difference between two runs of the reference by different steps: of attitudes in rad, or of ω relative.
    pub reference_uncertainty: f64,
}

impl Certificate {
    /// Everything in it, as name (with unit) and value: as recordings carry it.
    #[must_use]
    pub fn facts(&self) -> Vec<(&'static str, String)> {
        let figures = [
            ("attitude_error_rad", self.attitude_rad),
            ("angular_velocity_error_relative", Some(self.angular_velocity_relative)),
            ("angular_momentum_error_relative", self.angular_momentum_relative),
            ("position_error_m", self.position_m),
        ];
        let figures = figures.into_iter().filter_map(|(name, figure)| Some((name, format!("{:.3e}", figure?))));
        let rest = [
            ("worst_at_s", self.worst_at_s.to_string()),
            ("covered_to_s", self.covered_to_s.to_string()),
            ("covers_the_whole_run", self.is_whole.to_string()),
            ("samples_compared", self.samples.to_string()),
            ("method", self.method.clone()),
            ("reference", self.reference.clone()),
            ("reference_uncertainty", format!("{:.0e}", self.reference_uncertainty)),
        ];
        figures.chain(rest).collect()
    }

    /// What facts that a recording carries say: the figures as far as they were written down. `None` if one is missing.
    #[must_use]
    pub fn from_facts(facts: &[(String, String)]) -> Option<Self> {
        let fact = |name: &str| facts.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str());
        let number = |name: &str| fact(name)?.parse().ok();
        Some(Self {
            attitude_rad: number("attitude_error_rad"),
            angular_velocity_relative: number("angular_velocity_error_relative")?,
            angular_momentum_relative: number("angular_momentum_error_relative"),
            position_m: number("position_error_m"),
            worst_at_s: number("worst_at_s")?,
            covered_to_s: number("covered_to_s")?,
            is_whole: fact("covers_the_whole_run")?.parse().ok()?,
            samples: fact("samples_compared")?.parse().ok()?,
            method: fact("method")?.to_owned(),
            reference: fact("reference")?.to_owned(),
            reference_uncertainty: number("reference_uncertainty")?,
        })
    }

    /// Whether the attitude keeps a tolerance in rad, over the whole run: what was not compared does not keep it.
    #[must_use]
    pub fn keeps(&self, tolerance_rad: f64) -> bool {
        self.is_whole && self.attitude_rad.is_none_or(|error| error <= tolerance_rad)
    }
}
