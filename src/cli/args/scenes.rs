use clap::{Args, ValueEnum};

use super::Overrides;

#[derive(Debug, Args)]
pub(in crate::cli) struct ListArguments {
    /// As JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PlanArguments {
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
pub(in crate::cli) struct CheckArguments {
    /// TOML files, or names of scenes that come with the program.
    #[arg(required = true, value_name = "FILE|SCENE")]
    pub scenes: Vec<String>,
    /// Any key of the scenes, such as `body.0.angular_velocity_rad_s=[0, 5, 0.01]`.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// As JSON, faults with file, line, column and key.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct NewArguments {
    /// The file to write, .toml (added where it is left out); `-` for standard output.
    pub name: String,
    /// What to begin with.
    #[arg(long, value_enum, default_value_t = Template::Free)]
    pub template: Template,
    /// Copy this scene: a name or a TOML file.
    #[arg(long, value_name = "SCENE", conflicts_with = "template")]
    pub from: Option<String>,
    /// Overwrite a file that is there already.
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Template {
    /// A slab in free rotation.
    Free,
    /// A top on its point.
    Pivot,
    /// A craft with a thruster and a brake.
    Torque,
}
