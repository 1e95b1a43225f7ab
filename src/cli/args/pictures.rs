use std::path::PathBuf;

use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct PlotArguments {
    /// A recording (.mcap, .rrd, .csv), or the name of a scene, or a TOML file.
    #[arg(value_name = "FILE|SCENE")]
    pub what: String,
    /// The plot: .svg or .png (two pixels to one of the .svg).
    #[arg(long, short, value_name = "OUT")]
    pub output: PathBuf,
    /// What to draw, channels by name and the figures polhode, herpolhode and `axis_path`; left out: what tells most.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub channels: Vec<String>,
    /// Of which bodies, by name; left out: of all.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub body: Vec<String>,
    /// From when, s.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub from: Option<f64>,
    /// Until when, s.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub to: Option<f64>,
    #[command(flatten)]
    pub scene: SceneOf,
    /// Overwrite a plot that is there already.
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ReportArguments {
    /// A recording (.mcap, .rrd, .csv), or the name of a scene, or a TOML file.
    #[arg(value_name = "FILE|SCENE")]
    pub what: String,
    /// The page, .html.
    #[arg(long, short, value_name = "OUT")]
    pub output: PathBuf,
    /// Measure the error of a scene's motion against one in double-double. A recording has what was measured.
    #[arg(long)]
    pub certify: bool,
    #[command(flatten)]
    pub scene: SceneOf,
    /// Overwrite a page that is there already.
    #[arg(long)]
    pub force: bool,
}

/// Which scene a motion is of.
#[derive(Debug, Args)]
pub(in crate::cli) struct SceneOf {
    /// The scene that a recording is of, for one that carries none: a name or a TOML file, refused where its values are
    /// others than the recording's.
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    /// Any key of the scene, such as `body.0.angular_velocity_rad_s=[0, 5, 0.01]`.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}
