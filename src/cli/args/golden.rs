use std::path::PathBuf;

use clap::Args;

use super::FileFormat;

#[derive(Debug, Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(in crate::cli) struct GoldenArguments {
    /// Names of scenes that come with the program, or TOML files; left out: all of them, and then the folder must hold the
    /// goldens of these and nothing else.
    #[arg(conflicts_with = "scenes_in")]
    pub scenes: Vec<String>,
    /// The folder with the goldens.
    #[arg(long, value_name = "FOLDER", default_value = "recordings/golden")]
    pub folder: PathBuf,
    /// All scenes are the TOML files of this folder, in place of those that come with the program.
    #[arg(long, value_name = "FOLDER")]
    pub scenes_in: Option<PathBuf>,
    /// Run the scenes anew and hold the goldens to that, byte for byte and bit for bit: what is done where `--bless` is not
    /// given.
    #[arg(long, conflicts_with = "bless")]
    pub check: bool,
    /// Hold values to the bit, but not bytes: another version of this program may write the same values in other bytes.
    #[arg(long, conflicts_with = "bless")]
    pub values: bool,
    /// Write the goldens that changed, and say by how much.
    #[arg(long)]
    pub bless: bool,
    /// The formats that a golden has.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "mcap,rrd")]
    pub format: Vec<FileFormat>,
    /// Results as JSON.
    #[arg(long)]
    pub json: bool,
}
