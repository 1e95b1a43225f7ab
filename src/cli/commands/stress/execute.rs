use std::path::Path;
use std::{fs, io};

use rayon::prelude::*;
use serde_json::Value;
use thiserror::Error;

use super::{json, matrix, plot};
use crate::cli::args::StressArguments;
use crate::cli::execute::Outcome;
use crate::cli::output::{print, print_json, remark};
use crate::plot::{Format, PlotError};
use crate::scenario::Method;
use crate::study::{Case, Depth, Row, Verdict, cases, stress};

/// Why there is no result.
#[derive(Debug, Error)]
pub enum StressError {
    #[error("--methods: {0:?} is no method: take {names}", names = names())]
    UnknownMethod(String),
    #[error("--cases: {0:?} is no case: take {cases}", cases = case_names())]
    UnknownCase(String),
    #[error("--plot: {0}")]
    Plot(#[from] PlotError),
    #[error("cannot write {path}: {source}")]
    File { path: String, source: io::Error },
}

/// What is run.
pub struct Matrix {
    pub depth: Depth,
    pub methods: Vec<Method>,
    pub rows: Vec<Row>,
}

/// Runs the cases side by side: nothing is timed.
pub fn execute(arguments: &StressArguments) -> io::Result<Outcome> {
    let matrix = match matrix(arguments) {
        Ok(matrix) => matrix,
        Err(error) => return Ok(impossible(&error)),
    };
    if arguments.json {
        print_json(&Value::Array(matrix.rows.iter().map(json::row).collect()))?;
    } else {
        print(&matrix::as_text(&matrix))?;
    }
    let cells = || matrix.rows.iter().flat_map(|row| &row.cells);
    let is_wrong = cells().any(|cell| cell.verdict == Verdict::Wrong);
    let outcome = if is_wrong { Outcome::Failed } else { Outcome::Done };
    Ok(draw(arguments, &matrix).map_or_else(|error| impossible(&error), |()| outcome))
}

fn impossible(error: &StressError) -> Outcome {
    remark(&format!("error: {error}"));
    Outcome::Impossible
}

fn matrix(arguments: &StressArguments) -> Result<Matrix, StressError> {
    let depth = if arguments.full { Depth::Full } else { Depth::Quick };
    let method = |name: &String| {
        let found = Method::ALL.into_iter().find(|method| method.key() == name);
        found.ok_or_else(|| StressError::UnknownMethod(name.clone()))
    };
    let mut methods = arguments.methods.iter().map(method).collect::<Result<Vec<_>, _>>()?;
    if methods.is_empty() {
        methods = Method::ALL.to_vec();
    }
    let cases = chosen(arguments, depth)?;
    arguments.plot.iter().try_for_each(|path| Format::of(path).map(|_| ()))?;
    let rows = cases.par_iter().with_max_len(1).map(|case| stress(case, &methods, depth)).collect();
    Ok(Matrix { depth, methods, rows })
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

fn names() -> String {
    Method::ALL.map(Method::key).join(", ")
}

fn case_names() -> String {
    cases().iter().map(|case| case.key).collect::<Vec<_>>().join(", ")
}

fn draw(arguments: &StressArguments, matrix: &Matrix) -> Result<(), StressError> {
    for path in &arguments.plot {
        write(path, &Format::of(path)?.bytes(&plot::draw(matrix))?)?;
    }
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), StressError> {
    fs::write(path, bytes).map_err(|source| StressError::File { path: path.display().to_string(), source })
}
