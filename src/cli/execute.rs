use std::io;
use std::path::Path;
use std::process::ExitCode;

use super::Arguments;
use super::args::Command;
use super::commands::{
    bench, compare, convert, digest, golden, inspect, list, plan, plot, recover, report, run, stress, verify, view,
};
use super::output::remark;
use crate::scenario::{Scenario, ScenarioError};

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Outcome {
    /// All is well.
    Done,
    /// A check failed, or two recordings differ.
    Failed,
    /// Something could not be done; it has been said.
    Impossible,
}

/// Does what was asked, says so, and tells how it ended.
#[must_use]
pub fn execute(arguments: Arguments) -> ExitCode {
    let outcome = match arguments.command {
        Command::List(arguments) => list::execute(&arguments),
        Command::Run(arguments) => run::execute(&arguments),
        Command::Plan(arguments) => plan::execute(&arguments),
        Command::Bench(arguments) => bench::execute(&arguments),
        Command::Stress(arguments) => stress::execute(&arguments),
        Command::Inspect(arguments) => inspect::execute(&arguments),
        Command::Verify(arguments) => verify::execute(&arguments),
        Command::Convert(arguments) => convert::execute(&arguments),
        Command::Compare(arguments) => compare::execute(&arguments),
        Command::Digest(arguments) => digest::execute(&arguments),
        Command::Recover(arguments) => recover::execute(&arguments),
        Command::Plot(arguments) => Ok(plot::execute(&arguments)),
        Command::Report(arguments) => Ok(report::execute(&arguments)),
        Command::Golden(arguments) => golden::execute(&arguments),
        Command::View(arguments) => Ok(view::execute(&arguments)),
    };
    let outcome = outcome.unwrap_or_else(|error: io::Error| {
        remark(&format!("error: cannot write to standard output: {error}"));
        Outcome::Impossible
    });
    ExitCode::from(match outcome {
        Outcome::Done => 0,
        Outcome::Failed => 1,
        Outcome::Impossible => 2,
    })
}

/// The scene that `name` means: a TOML file, or one that comes with the program.
pub(super) fn scenario(name: &str, assignments: &[String]) -> Result<Scenario, ScenarioError> {
    let path = Path::new(name);
    let is_file = path.extension().is_some_and(|extension| extension == "toml") || path.components().count() > 1;
    if is_file { Scenario::read(path, assignments) } else { Scenario::named(name, assignments) }
}
