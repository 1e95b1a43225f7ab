use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

const EXAMPLES: &str = "\
Examples:
  polhode list                                    what scenes there are
  polhode run dzhanibekov                         recordings/dzhanibekov.mcap, .layout.json and .rrd
  polhode run --all --out out --force             every scene
  polhode run my_scene.toml --format csv          a scene of your own, as a table
  polhode run dzhanibekov --duration 90 --sample-every 0.001
  polhode run my_scene.toml --set 'body.0.angular_velocity_rad_s=[0, 6, 0.1]'
  polhode run lagrange_top --certify              with its measured error, printed and recorded
  polhode plan lagrange_top                       which method, why, and what is skipped
  polhode run dzhanibekov --live                  into a Rerun viewer that is open
  polhode bench dzhanibekov --plot costs.svg      what each method costs for how much accuracy
  polhode inspect recordings/dzhanibekov.mcap     what is in a recording
  polhode convert run.mcap run.rrd run.csv        the same recording in other formats, to the bit
  polhode recover recordings/run.mcap.part        a whole recording of what a killed run left
  polhode view recordings/dzhanibekov.rrd         opens the Rerun viewer on it (or on a scene)

Exit codes: 0 done, 1 a check failed or a certified tolerance was missed, 2 could not (usage, input, file).";

/// Exact motions of rotating rigid bodies, recorded for Rerun and Foxglove.
#[derive(Debug, Parser)]
#[command(name = "polhode", version, after_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// List the scenes that come with the program.
    List(ListArguments),
    /// Run scenes, record them, measure their checks.
    #[command(after_help = EXAMPLES)]
    Run(RunArguments),
    /// Show how a scene would be run: each body's path, its reason, and what is skipped.
    Plan(PlanArguments),
    /// Measure what each method costs for how much accuracy, against a reference.
    Bench(BenchArguments),
    /// Show what is in a recording (.mcap, .rrd, .csv).
    Inspect(InspectArguments),
    /// Write a recording anew in other formats, every channel to the bit.
    ///
    /// Where the recording carries its scene (.mcap and .rrd do), the new one has pictures, layout and log: it is what a run
    /// to that format gives. Otherwise it has columns and words only.
    Convert(ConvertArguments),
    /// Make a whole recording of the .part that a killed run left, and say how many samples it kept.
    Recover(RecoverArguments),
    /// Open the Rerun viewer found on PATH on a recording or a scene.
    ///
    /// An .mcap, a .csv and a scene are first written as an .rrd to the system's folder for temporary files, where it stays
    /// until the viewer is closed.
    View(ViewArguments),
}

#[derive(Debug, Args)]
pub(super) struct ListArguments {
    /// As JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(super) struct RunArguments {
    /// Names of scenes that come with the program, or TOML files.
    #[arg(required_unless_present = "all", conflicts_with = "all")]
    pub scenes: Vec<String>,
    /// Every scene that comes with the program.
    #[arg(long)]
    pub all: bool,
    /// The folder that recordings go to; made if it is not there.
    #[arg(long, value_name = "FOLDER", default_value = "recordings")]
    pub out: PathBuf,
    /// What to write: mcap,rrd where neither this nor `--live` is given.
    #[arg(long, value_enum, value_delimiter = ',')]
    pub format: Vec<FileFormat>,
    /// Show the run in an open Rerun viewer, as it goes; files only where `--format` asks for them.
    #[arg(
        long,
        value_name = "ADDRESS",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "rerun+http://127.0.0.1:9876/proxy"
    )]
    pub live: Option<String>,
    /// Measure the error of each body's motion against one in double-double, print and record it; a tolerance that is
    /// missed, or cannot be certified over the whole run, exits with 1.
    #[arg(long)]
    pub certify: bool,
    /// Overwrite recordings that are there already.
    #[arg(long)]
    pub force: bool,
    /// Results as JSON.
    #[arg(long)]
    pub json: bool,
    /// Print nothing but errors.
    #[arg(long, short, conflicts_with = "json")]
    pub quiet: bool,
    #[command(flatten)]
    pub overrides: Overrides,
}

#[derive(Debug, Args)]
pub(super) struct PlanArguments {
    /// Names of scenes that come with the program, or TOML files.
    #[arg(required = true)]
    pub scenes: Vec<String>,
    /// As JSON.
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub overrides: Overrides,
}

#[derive(Debug, Args)]
pub(super) struct BenchArguments {
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

#[derive(Debug, Args)]
pub(super) struct InspectArguments {
    /// The recording.
    pub file: PathBuf,
    /// As JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub(super) struct ConvertArguments {
    /// The recording: .mcap, .rrd or .csv.
    #[arg(value_name = "IN")]
    pub input: PathBuf,
    /// What to write, the format by extension; beside an .mcap the layout to import.
    #[arg(value_name = "OUT", required = true)]
    pub outputs: Vec<PathBuf>,
    /// The scene that the recording is of: a name or a TOML file, refused where its values are others than the recording's.
    /// For a .csv, which carries none, and for a scene with mesh files.
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    /// Any key of that scene, as it was set for the run.
    #[arg(long, value_name = "KEY=VALUE", requires = "scene")]
    pub set: Vec<String>,
    /// Overwrite files that are there already.
    #[arg(long)]
    pub force: bool,
    /// Results as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub(super) struct RecoverArguments {
    /// What a killed run left: NAME.mcap.part, NAME.rrd.part or NAME.csv.part. It is removed once the recording is whole.
    pub file: PathBuf,
    /// The recording to make; left out: the name without .part. In another format it leaves the .part as it is.
    #[arg(long, short, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Overwrite a recording that is there already.
    #[arg(long)]
    pub force: bool,
    /// Results as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub(super) struct ViewArguments {
    /// A recording, or the name of a scene, or a TOML file.
    #[arg(value_name = "FILE|SCENE")]
    pub what: String,
}

/// Keys of the scene to change for this run.
#[derive(Debug, Args)]
pub(super) struct Overrides {
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

impl RunArguments {
    /// Whether something with pictures is asked for: they cost a preview of the run.
    pub fn draws(&self) -> bool {
        self.live.is_some() || self.formats().iter().any(|format| *format != FileFormat::Csv)
    }

    /// The formats to write.
    pub fn formats(&self) -> &[FileFormat] {
        let is_left_out = self.format.is_empty() && self.live.is_none();
        if is_left_out { &[FileFormat::Mcap, FileFormat::Rrd] } else { &self.format }
    }
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

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum FileFormat {
    /// For Foxglove and Lichtblick, and to keep; beside it NAME.layout.json, the layout to import there.
    Mcap,
    /// For Rerun.
    Rrd,
    /// A table with 17 digits.
    Csv,
}

impl FileFormat {
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Mcap => "mcap",
            Self::Rrd => "rrd",
            Self::Csv => "csv",
        }
    }
}
