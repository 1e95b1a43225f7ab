use std::ffi::OsString;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use super::Arguments;
use super::args::Command;
use super::commands::{
    bench, check, compare, convert, digest, golden, inspect, list, new, plan, plot, recover, report, run, schema,
    stress, verify, view,
};
use super::interrupt::{self, Signal};
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
    /// A signal has stopped it; what there is has been said.
    Interrupted(Signal),
}

/// What was asked on the command line.
///
/// # Errors
/// The exit code where there is nothing to do: help and version are shown, or what was asked is none of the program's
/// commands; that has been said.
pub fn asked() -> Result<Arguments, ExitCode> {
    Arguments::try_parse().map_err(|told| {
        if told.kind() == ErrorKind::InvalidUtf8 {
            let is_text = |word: &OsString| word.to_str().is_some();
            let others: Vec<_> = std::env::args_os().filter(|word| !is_text(word)).collect();
            remark(&format!(
                "error: {others:?}: only folders, recordings and files to write may have names that are not UTF-8"
            ));
            return ExitCode::from(2);
        }
        let code = u8::try_from(told.exit_code()).unwrap_or(2);
        match told.print() {
            Err(error) if code == 0 && error.kind() != io::ErrorKind::BrokenPipe => {
                ExitCode::from(unwritten(&error).code())
            }
            _ => ExitCode::from(code),
        }
    })
}

/// Does what was asked, says so, and tells how it ended.
#[must_use]
pub fn execute(arguments: Arguments) -> ExitCode {
    interrupt::watch();
    let outcome = match arguments.command {
        Command::List(arguments) => list::execute(&arguments),
        Command::New(arguments) => Ok(new::execute(&arguments)),
        Command::Check(arguments) => check::execute(&arguments),
        Command::Schema => schema::execute(),
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
    ExitCode::from(outcome.unwrap_or_else(|error| unwritten(&error)).code())
}

impl Outcome {
    const fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Failed => 1,
            Self::Impossible => 2,
            Self::Interrupted(signal) => signal.exit_code(),
        }
    }
}

fn unwritten(error: &io::Error) -> Outcome {
    remark(&format!("error: cannot write to standard output: {error}"));
    Outcome::Impossible
}

/// Says why a command did not come to its end.
pub(super) fn ended(error: &impl std::fmt::Display) -> Outcome {
    remark(&format!("error: {error}"));
    interrupt::signal().map_or(Outcome::Impossible, Outcome::Interrupted)
}

/// The scene that `name` means: a TOML file, or one that comes with the program.
pub(super) fn scenario(name: &str, assignments: &[String]) -> Result<Scenario, ScenarioError> {
    file(name).map_or_else(|| Scenario::named(name, assignments), |path| Scenario::read(path, assignments))
}

/// The same, or everything that is wrong with it.
pub(super) fn scenario_or_faults(name: &str, assignments: &[String]) -> Result<Scenario, Vec<ScenarioError>> {
    file(name).map_or_else(|| Scenario::named_all(name, assignments), |path| Scenario::read_all(path, assignments))
}

/// The file that is meant, if it is one.
fn file(name: &str) -> Option<&Path> {
    let path = Path::new(name);
    let is_file = path.extension().is_some_and(|extension| extension == "toml") || path.components().count() > 1;
    is_file.then_some(path)
}
