use clap::Args;

/// Keys of the scene to change for this run.
#[derive(Debug, Args)]
pub(in crate::cli) struct Overrides {
    /// Propagate by auto, `closed_form`, taylor, dop853, or in fixed steps (`--step`) by `euler_naive`,
    /// `euler_semi_implicit`, rk4, rkmk4, splitting2 (4, 6, 8), dmv2 (4, 6, 8), gauss4 (6) or kicks2 (4).
    #[arg(long, value_name = "METHOD")]
    pub method: Option<String>,
    /// Attitude error to keep over the whole run, rad; `--certify` holds the run to it.
    #[arg(long, value_name = "RAD", allow_hyphen_values = true)]
    pub tolerance: Option<String>,
    /// Step of a method with a fixed step, s.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub step: Option<String>,
    /// How long, s.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub duration: Option<String>,
    /// Time between samples, s.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub sample_every: Option<String>,
    /// What to record, by name, in place of what the scene says.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub channels: Vec<String>,
    /// Any key of the scene, such as `body.0.angular_velocity_rad_s=[0, 5, 0.01]`.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

impl Overrides {
    /// As assignments, in the order in which they are carried out.
    pub fn assignments(&self) -> Vec<String> {
        let keys = [
            ("method", &self.method),
            ("tolerance_rad", &self.tolerance),
            ("step_s", &self.step),
            ("duration_s", &self.duration),
            ("sample_every_s", &self.sample_every),
        ];
        let given = keys.iter().filter_map(|(key, value)| value.as_ref().map(|value| format!("{key}={value}")));
        let channels = (!self.channels.is_empty()).then(|| format!("channels={:?}", self.channels));
        given.chain(channels).chain(self.set.iter().cloned()).collect()
    }
}
