use std::io;
use std::path::Path;

use serde_json::json;

use crate::cli::args::RecoverArguments;
use crate::cli::execute::Outcome;
use crate::cli::output::{print, print_json, remark};
use crate::cli::report::{files_as_json, files_as_text};
use crate::plot::grouped;
use crate::recording::{Recovered, recover};

/// Makes a whole recording of what a killed run left.
pub fn execute(arguments: &RecoverArguments) -> io::Result<Outcome> {
    let recovered = match recover(&arguments.file, arguments.output.as_deref(), arguments.force) {
        Ok(recovered) => recovered,
        Err(error) => {
            remark(&format!("error: {error}"));
            return Ok(Outcome::Impossible);
        }
    };
    if arguments.json {
        print_json(&as_json(&arguments.file, &recovered))?;
    } else {
        print(&as_text(&arguments.file, &recovered))?;
    }
    super::convert::say_why_there_is_no_picture(&arguments.file, &recovered.conversion);
    Ok(Outcome::Done)
}

fn as_text(part: &Path, recovered: &Recovered) -> String {
    let survey = recovered.conversion.survey();
    let planned = recovered.planned.map(|planned| format!(" of {}", grouped(planned))).unwrap_or_default();
    let (kept, end) = (grouped(survey.samples), survey.to_s.unwrap_or(0.0));
    let files = files_as_text(std::slice::from_ref(&recovered.file));
    let text = format!("{}: {kept}{planned} samples kept, to {end} s\n{files}", part.display());
    match &recovered.part {
        Some(part) => format!("{text}  {} is kept: another format does not hold all of it\n", part.display()),
        None => text,
    }
}

fn as_json(part: &Path, recovered: &Recovered) -> serde_json::Value {
    let survey = recovered.conversion.survey();
    json!({
        "from": part.display().to_string(),
        "kept": survey.samples,
        "planned": recovered.planned,
        "to_s": survey.to_s,
        "has_scene": recovered.conversion.plan().is_some(),
        "remark": recovered.conversion.remark(),
        "files": files_as_json(std::slice::from_ref(&recovered.file)),
    })
}
