use std::io;

use super::examine::examine;
use super::report::{as_json, as_text};
use crate::cli::args::GoldenArguments;
use crate::cli::execute::{Outcome, ended};
use crate::cli::interrupt::Patient;
use crate::cli::output::{print, print_json};

/// Holds goldens to their scenes, or writes them.
pub fn execute(arguments: &GoldenArguments) -> io::Result<Outcome> {
    let patient = Patient::new();
    let examination = match examine(arguments) {
        Ok(examination) => examination,
        Err(error) => return Ok(ended(&error)),
    };
    drop(patient);
    if arguments.json {
        print_json(&as_json(&examination, arguments))?;
    } else {
        print(&as_text(&examination, arguments))?;
    }
    let is_right = match (arguments.bless, arguments.values) {
        (true, _) => examination.extra.is_empty(),
        (false, true) => examination.has_same_values(),
        (false, false) => examination.is_same(),
    };
    Ok(if is_right { Outcome::Done } else { Outcome::Failed })
}
