use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::Overrides;

#[derive(Debug, Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(in crate::cli) struct RunArguments {
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

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum FileFormat {
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
