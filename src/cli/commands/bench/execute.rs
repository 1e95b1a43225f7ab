use std::io;
use std::path::Path;

use serde_json::Value;
use thiserror::Error;

use super::{clock, csv, plot, report};
use crate::cli::args::BenchArguments;
use crate::cli::execute::{Outcome, ended, scenario};
use crate::cli::interrupt::{self, Patient, Signal};
use crate::cli::names::method;
use crate::cli::output::{print, print_json, write};
use crate::plot::{Format, PlotError};
use crate::recording::{PartFile, RecordingError};
use crate::scenario::{Plan, ScenarioError};
use crate::study::{Request, WorkPrecision, work_precision};

/// Why there is no result.
#[derive(Debug, Error)]
pub enum BenchError {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error("{0}: interrupted: nothing is told or written")]
    Interrupted(Signal),
    #[error("{0}")]
    UnknownMethod(String),
    #[error("--errors: {0:?} rad must be positive and at most π")]
    BadError(f64),
    #[error(transparent)]
    File(#[from] RecordingError),
    #[error("--csv: {0:?}: a table's name ends in .csv")]
    NoTable(String),
    #[error("--plot: {0}")]
    Plot(#[from] PlotError),
}

/// A scene's name and the study of each of its bodies.
pub type Studies = Vec<(String, Vec<WorkPrecision>)>;

/// Measures scenes one after another, on one thread: what ran beside it would spoil its times.
pub fn execute(arguments: &BenchArguments) -> io::Result<Outcome> {
    let patient = Patient::new();
    let studies = match studies(arguments) {
        Ok(studies) => studies,
        Err(error) => return Ok(ended(&error)),
    };
    drop(patient);
    if arguments.json {
        print_json(&Value::Array(studies.iter().map(report::as_json).collect()))?;
    } else {
        print(&studies.iter().map(report::as_text).collect::<Vec<_>>().join("\n"))?;
    }
    Ok(files(arguments, &studies).map_or_else(|error| ended(&error), |()| Outcome::Done))
}

fn studies(arguments: &BenchArguments) -> Result<Studies, BenchError> {
    let request = request(arguments)?;
    check_names(arguments)?;
    let mut assignments: Vec<String> = arguments.duration.iter().map(|value| format!("duration_s={value}")).collect();
    assignments.extend(arguments.set.iter().cloned());
    // Every scene is planned before any is measured: a mistake in the last must not cost the time of the first.
    let plan = |name: &String| Plan::new(&scenario(name, &assignments)?);
    let plans = arguments.scenes.iter().map(plan).collect::<Result<Vec<_>, _>>()?;
    let study = |plan: &Plan| {
        let body = |body| match interrupt::signal() {
            Some(signal) => Err(BenchError::Interrupted(signal)),
            None => Ok(work_precision(body, plan.grid.end(), &request)?),
        };
        Ok((plan.name.clone(), plan.bodies.iter().map(body).collect::<Result<Vec<_>, _>>()?))
    };
    plans.iter().map(study).collect()
}

fn request(arguments: &BenchArguments) -> Result<Request, BenchError> {
    let method = |name: &String| method(name).map_err(BenchError::UnknownMethod);
    let mut request = Request { clock: clock::clock, budget_s: arguments.budget, ..Request::default() };
    if !arguments.methods.is_empty() {
        request.methods = arguments.methods.iter().map(method).collect::<Result<_, _>>()?;
    }
    if let Some(bad) = arguments.errors.iter().find(|error| !(**error > 0.0 && **error <= std::f64::consts::PI)) {
        return Err(BenchError::BadError(*bad));
    }
    request.errors_rad.clone_from(&arguments.errors);
    Ok(request)
}

/// Before anything is measured: a misspelt name must not cost the time of a study.
fn check_names(arguments: &BenchArguments) -> Result<(), BenchError> {
    let shown = |path: &Path| path.display().to_string();
    let is_table = |path: &Path| path.extension().is_some_and(|extension| extension == "csv");
    if let Some(path) = arguments.csv.as_deref().filter(|path| !is_table(path)) {
        return Err(BenchError::NoTable(shown(path)));
    }
    arguments.plot.iter().try_for_each(|path| Format::of(path).map(|_| ()).map_err(BenchError::from))
}

fn files(arguments: &BenchArguments, studies: &Studies) -> Result<(), BenchError> {
    if let Some(path) = &arguments.csv {
        write(PartFile::create(path, true)?, csv::table(studies).as_bytes())?;
    }
    for path in &arguments.plot {
        write(PartFile::create(path, true)?, &Format::of(path)?.bytes(&plot::draw(studies))?)?;
    }
    Ok(())
}
