use std::io;

use rayon::prelude::*;
use serde_json::Value;
use thiserror::Error;

use super::{json, matrix, plot};
use crate::cli::args::StressArguments;
use crate::cli::execute::{Outcome, ended};
use crate::cli::interrupt::{self, Patient, Signal};
use crate::cli::names::{hint, method};
use crate::cli::output::{print_coloured, print_json, write};
use crate::cli::threads::{self, NoThreads};
use crate::plot::{Format, PlotError};
use crate::recording::{PartFile, RecordingError};
use crate::scenario::Method;
use crate::study::{Case, Depth, Row, Verdict, cases};

/// Why there is no result.
#[derive(Debug, Error)]
pub enum StressError {
    #[error("{0}")]
    UnknownMethod(String),
    #[error("--cases: {0:?} is no case: {hint}", hint = case_hint(.0))]
    UnknownCase(String),
    #[error("{signal}: interrupted: of {all} cases, {done} were done")]
    Interrupted { signal: Signal, done: usize, all: usize },
    #[error("--plot: {0}")]
    Plot(#[from] PlotError),
    #[error(transparent)]
    File(#[from] RecordingError),
    #[error(transparent)]
    NoThreads(#[from] NoThreads),
}

/// What is run.
pub struct Matrix {
    pub depth: Depth,
    pub methods: Vec<Method>,
    pub rows: Vec<Row>,
}

/// Runs the cases side by side: nothing is timed.
pub fn execute(arguments: &StressArguments) -> io::Result<Outcome> {
    let patient = Patient::new();
    let matrix = match matrix(arguments) {
        Ok(matrix) => matrix,
        Err(error) => return Ok(ended(&error)),
    };
    drop(patient);
    if arguments.json {
        print_json(&Value::Array(matrix.rows.iter().map(json::row).collect()))?;
    } else {
        print_coloured(&matrix::as_text(&matrix, &arguments.show))?;
    }
    let cells = || matrix.rows.iter().flat_map(|row| &row.cells);
    let is_wrong = cells().any(|cell| cell.verdict == Verdict::Wrong);
    let outcome = if is_wrong { Outcome::Failed } else { Outcome::Done };
    Ok(draw(arguments, &matrix).map_or_else(|error| ended(&error), |()| outcome))
}

fn matrix(arguments: &StressArguments) -> Result<Matrix, StressError> {
    let depth = if arguments.full { Depth::Full } else { Depth::Quick };
    let method = |name: &String| method(name).map_err(StressError::UnknownMethod);
    let mut methods = arguments.methods.iter().map(method).collect::<Result<Vec<_>, _>>()?;
    if methods.is_empty() {
        methods = Method::ALL.to_vec();
    }
    let cases = chosen(arguments, depth)?;
    arguments.plot.iter().try_for_each(|path| Format::of(path).map(|_| ()))?;
    threads::start()?;
    let rows: Vec<Row> = cases.par_iter().with_max_len(1).filter_map(|case| row(case, &methods, depth)).collect();
    if let Some(signal) = interrupt::signal().filter(|_| rows.len() < cases.len()) {
        return Err(StressError::Interrupted { signal, done: rows.len(), all: cases.len() });
    }
    Ok(Matrix { depth, methods, rows })
}

/// Its cells side by side, too: those of the longest case take longer than all others. After a signal none is begun.
fn row(case: &Case, methods: &[Method], depth: Depth) -> Option<Row> {
    let goes_on = || interrupt::signal().is_none();
    let row = goes_on().then(|| Row::begin(case))?;
    let cell = |method: &Method| goes_on().then(|| row.cell(*method, depth));
    let cells = methods.par_iter().with_max_len(1).map(cell).collect::<Option<_>>()?;
    Some(Row { cells, ..row })
}

/// The cases of this depth, or those asked for by name at any.
fn chosen(arguments: &StressArguments, depth: Depth) -> Result<Vec<Case>, StressError> {
    let all = cases();
    if let Some(unknown) = arguments.cases.iter().find(|name| all.iter().all(|case| case.key != *name)) {
        return Err(StressError::UnknownCase(unknown.clone()));
    }
    let is_chosen = |case: &Case| match arguments.cases.as_slice() {
        [] => case.depth <= depth,
        names => names.iter().any(|name| name == case.key),
    };
    Ok(all.into_iter().filter(is_chosen).collect())
}

fn case_hint(name: &str) -> String {
    let cases = cases();
    hint(name, &cases.iter().map(|case| case.key).collect::<Vec<_>>())
}

fn draw(arguments: &StressArguments, matrix: &Matrix) -> Result<(), StressError> {
    for path in &arguments.plot {
        write(PartFile::create(path, true)?, &Format::of(path)?.bytes(&plot::draw(matrix))?)?;
    }
    Ok(())
}
