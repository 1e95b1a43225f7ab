use std::path::PathBuf;

use clap::Args;

#[derive(Debug, Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(in crate::cli) struct CompareArguments {
    /// A recording (.mcap, .rrd, .csv), or a scene: its name or a TOML file.
    pub a: String,
    /// What to compare it with. A scene is computed at the other side's times.
    pub b: String,
    /// How far values may be apart, in the unit of the channel (of attitudes rad) and, after a comma, as a share of its largest
    /// size; or `exact`, or `shown` for what is not judged.
    #[arg(long, value_name = "CHANNEL=ABSOLUTE[,RELATIVE]")]
    pub tolerance: Vec<String>,
    /// The same from a TOML file: `attitude_rad = 1e-9`.
    #[arg(long, value_name = "FILE")]
    pub tolerances: Option<PathBuf>,
    /// Every bit must be the same, and every time.
    #[arg(long, conflicts_with_all = ["tolerance", "tolerances"])]
    pub exact: bool,
    /// Compare these channels only.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub channels: Vec<String>,
    /// A body of A that is called otherwise in B.
    #[arg(long, value_name = "A=B")]
    pub body: Vec<String>,
    /// Interpolate B at the times of A, where they have recordings at other times; says how far that may be off.
    #[arg(long, conflicts_with = "exact")]
    pub resample: bool,
    /// Put the clock of B forward, s.
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_hyphen_values = true)]
    pub shift: f64,
    /// Compare from this time of A on, s.
    #[arg(long, value_name = "S")]
    pub from: Option<f64>,
    /// Compare up to this time of A, s.
    #[arg(long, value_name = "S")]
    pub to: Option<f64>,
    /// Any key of A, where it is a scene, such as `method=rk4`.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set_a: Vec<String>,
    /// Any key of B, where it is a scene.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set_b: Vec<String>,
    /// Both motions over each other, with how far they are apart: an .rrd for the Rerun viewer.
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// How far they are apart over time, drawn: .svg or .png.
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Overwrite what is there under these names.
    #[arg(long)]
    pub force: bool,
    /// Everything that was found, as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct DigestArguments {
    /// Recordings: .mcap, .rrd, .csv.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// As JSON.
    #[arg(long)]
    pub json: bool,
}
