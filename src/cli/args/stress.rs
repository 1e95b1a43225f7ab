use std::path::PathBuf;

use clap::{Args, ValueEnum};

#[derive(Debug, Args)]
pub(in crate::cli) struct StressArguments {
    /// Some eight turns of each motion, two steps, one tolerance: seconds. This is what is done if nothing is said.
    #[arg(long, conflicts_with = "full")]
    pub quick: bool,
    /// Up to 1e9 s and 1e8 steps, many steps and tolerances: many minutes.
    #[arg(long)]
    pub full: bool,
    /// By these; left out: by every one.
    #[arg(long, value_name = "METHOD,…", value_delimiter = ',')]
    pub methods: Vec<String>,
    /// These motions; left out: all of them.
    #[arg(long, value_name = "CASE,…", value_delimiter = ',')]
    pub cases: Vec<String>,
    /// A matrix of each of these.
    #[arg(long, value_name = "WHAT,…", value_delimiter = ',', value_enum, default_value = "attitude")]
    pub show: Vec<Shown>,
    /// Every run of every cell, as JSON.
    #[arg(long)]
    pub json: bool,
    /// The matrix, drawn: .svg or .png.
    #[arg(long, value_name = "FILE")]
    pub plot: Vec<PathBuf>,
}

/// What a matrix shows of each cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Shown {
    /// How right the attitude is, and what to make of it.
    Attitude,
    /// How well energy is kept, and by which law its error grows.
    Energy,
    /// How well angular momentum is kept, and by which law its error grows.
    Momentum,
    /// At which step a method breaks.
    Breaks,
    /// How long it lasts with that step.
    Lasts,
}
