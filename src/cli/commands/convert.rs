use std::io;
use std::path::Path;

use serde_json::json;
use thiserror::Error;

use crate::cli::args::ConvertArguments;
use crate::cli::execute::{Outcome, scenario};
use crate::cli::layout;
use crate::cli::output::{print, print_json, remark};
use crate::cli::report::{files_as_json, files_as_text};
use crate::cli::space::{self, NoRoom};
use crate::plot::grouped;
use crate::recording::{Conversion, Finished, PartFile, RecordingError};
use crate::scenario::{Plan, ScenarioError};

/// Why a recording was not converted.
#[derive(Debug, Error)]
enum ConvertError {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error(transparent)]
    NoRoom(#[from] NoRoom),
}

/// Writes a recording anew, in other formats.
pub fn execute(arguments: &ConvertArguments) -> io::Result<Outcome> {
    let (conversion, files) = match convert(arguments) {
        Ok(done) => done,
        Err(error) => {
            remark(&format!("error: {error}"));
            return Ok(Outcome::Impossible);
        }
    };
    let input = arguments.input.display();
    let survey = conversion.survey();
    if arguments.json {
        print_json(&json!({
            "from": input.to_string(),
            "samples": survey.samples,
            "from_s": survey.from_s,
            "to_s": survey.to_s,
            "has_scene": conversion.plan().is_some(),
            "remark": conversion.remark(),
            "files": files_as_json(&files),
        }))?;
    } else {
        let (samples, end) = (grouped(survey.samples), survey.to_s.unwrap_or(0.0));
        print(&format!("{input}: {samples} samples, to {end} s\n{}", files_as_text(&files)))?;
    }
    if arguments.outputs.iter().any(|output| !has_extension(output, "csv")) {
        say_why_there_is_no_picture(&arguments.input, &conversion);
    }
    Ok(Outcome::Done)
}

fn convert(arguments: &ConvertArguments) -> Result<(Conversion, Vec<Finished>), ConvertError> {
    let conversion = match &arguments.scene {
        Some(scene) => Conversion::with_plan(&arguments.input, Plan::new(&scenario(scene, &arguments.set)?)?)?,
        None => Conversion::of(&arguments.input)?,
    };
    space::check_anew(conversion.survey(), &arguments.outputs)?;
    let mut layouts = Vec::new();
    if let Some(plan) = conversion.plan() {
        for output in arguments.outputs.iter().filter(|output| has_extension(output, "mcap")) {
            layouts.push((plan, PartFile::create(&output.with_extension("layout.json"), arguments.force)?));
        }
    }
    let files = conversion.write(&arguments.outputs, arguments.force)?;
    for (plan, file) in layouts {
        layout::write(plan, file)?;
    }
    Ok((conversion, files))
}

/// Pictures need the scene.
pub fn say_why_there_is_no_picture(input: &Path, conversion: &Conversion) {
    if let Some(reason) = conversion.remark() {
        remark(&format!("{}: columns and words only, nothing is drawn: {reason}", input.display()));
    }
}

pub fn has_extension(path: &Path, wanted: &str) -> bool {
    path.extension().is_some_and(|extension| extension == wanted)
}
