use clap::Args;

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
