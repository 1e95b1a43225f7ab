//! The `polhode` program: parse, execute, exit.

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    polhode::cli::execute(polhode::cli::Arguments::parse())
}
