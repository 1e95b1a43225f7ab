use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::cli::args::{NewArguments, Template};
use crate::cli::execute::{Outcome, scenario};
use crate::cli::output::{self, print, remark};
use crate::recording::{PartFile, RecordingError};
use crate::scenario::{Plan, Scenario, ScenarioError};

/// Why there is no new scene.
#[derive(Debug, Error)]
enum NewError {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    File(#[from] RecordingError),
    #[error("cannot write to standard output: {0}")]
    Output(std::io::Error),
    #[error("{0}: a scene's name ends in .toml, or has no ending")]
    Ending(String),
}

/// Writes a scene to begin with.
pub fn execute(arguments: &NewArguments) -> Outcome {
    match write(arguments) {
        Ok(Some(path)) => {
            let shown = path.display();
            remark(&format!("{shown} is written: polhode check {shown}, then polhode run {shown}"));
            Outcome::Done
        }
        Ok(None) => Outcome::Done,
        Err(error) => {
            remark(&format!("error: {error}"));
            Outcome::Impossible
        }
    }
}

/// Where it was written, if it was to a file.
fn write(arguments: &NewArguments) -> Result<Option<PathBuf>, NewError> {
    let text = match &arguments.from {
        Some(name) => copy(name)?,
        None => template(arguments.template).to_owned(),
    };
    if arguments.name == "-" {
        print(&text).map_err(NewError::Output)?;
        return Ok(None);
    }
    let path = path(&arguments.name)?;
    output::write(PartFile::create(&path, arguments.force)?, text.as_bytes())?;
    Ok(Some(path))
}

fn path(name: &str) -> Result<PathBuf, NewError> {
    let path = Path::new(name);
    match path.extension() {
        Some(extension) if extension == "toml" => Ok(path.to_path_buf()),
        Some(_) => Err(NewError::Ending(name.to_owned())),
        None => Ok(path.with_extension("toml")),
    }
}

/// The text of a scene that comes with the program, or of a file, which must be sound.
fn copy(name: &str) -> Result<String, NewError> {
    let scenario = scenario(name, &[])?;
    Plan::new(&scenario)?;
    let Scenario { text, .. } = scenario;
    Ok(text)
}

const fn template(template: Template) -> &'static str {
    match template {
        Template::Free => include_str!("../templates/free.toml"),
        Template::Pivot => include_str!("../templates/pivot.toml"),
        Template::Torque => include_str!("../templates/torque.toml"),
    }
}
