use std::path::PathBuf;

use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct BenchArguments {
    /// Names of scenes that come with the program, or TOML files.
    #[arg(required = true)]
    pub scenes: Vec<String>,
    /// By these; left out: by the exact ones and one yardstick of each kind. `auto` stands for what it picks.
    #[arg(long, value_name = "METHOD,…", value_delimiter = ',')]
    pub methods: Vec<String>,
    /// Attitude errors to reach, rad.
    #[arg(long, value_name = "RAD,…", value_delimiter = ',', default_value = "1e-3,1e-6,1e-9,1e-12")]
    pub errors: Vec<f64>,
    /// How long to repeat runs for the sake of the median, s, for each body.
    #[arg(long, value_name = "S", default_value_t = 2.0)]
    pub budget: f64,
    /// Results as JSON.
    #[arg(long)]
    pub json: bool,
    /// Every run measured, as a table.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Error against cost, drawn: .svg or .png.
    #[arg(long, value_name = "FILE")]
    pub plot: Vec<PathBuf>,
    /// How long the motion lasts, s.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub duration: Option<String>,
    /// Any key of the scene, such as `body.0.angular_velocity_rad_s=[0, 5, 0.01]`.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}
