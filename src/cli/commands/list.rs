use std::io;

use serde_json::{Value, json};

use crate::cli::args::ListArguments;
use crate::cli::execute::Outcome;
use crate::cli::output::{print, print_json, remark};
use crate::cli::table::Table;
use crate::scenario::{Scenario, library};

/// Names and titles of the scenes that come with the program.
pub fn execute(arguments: &ListArguments) -> io::Result<Outcome> {
    let mut table = Table::default();
    let mut values = Vec::new();
    for name in library::names() {
        let scenario = match Scenario::named(name, &[]) {
            Ok(scenario) => scenario,
            Err(error) => {
                remark(&format!("error: {error}"));
                return Ok(Outcome::Impossible);
            }
        };
        table.row([name, scenario.title.as_str()]);
        values.push(json!({ "name": name, "title": scenario.title, "summary": scenario.summary }));
    }
    if arguments.json {
        print_json(&Value::Array(values))?;
    } else {
        print(&table.render(""))?;
    }
    Ok(Outcome::Done)
}
