use std::io;

use crate::cli::execute::Outcome;
use crate::cli::output::print;
use crate::scenario::schema;

/// The JSON Schema of scenes.
pub fn execute() -> io::Result<Outcome> {
    print(&schema())?;
    Ok(Outcome::Done)
}
