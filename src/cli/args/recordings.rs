use std::path::PathBuf;

use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct InspectArguments {
    /// The recording.
    pub file: PathBuf,
    /// As JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ConvertArguments {
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
pub(in crate::cli) struct RecoverArguments {
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
pub(in crate::cli) struct ViewArguments {
    /// A recording, or the name of a scene, or a TOML file.
    #[arg(value_name = "FILE|SCENE")]
    pub what: String,
}
