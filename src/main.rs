//! The `polhode` program: parse, execute, exit.

use std::process::ExitCode;

fn main() -> ExitCode {
    polhode::cli::asked().map_or_else(|code| code, polhode::cli::execute)
}
