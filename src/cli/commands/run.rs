use std::io;
use std::path::PathBuf;
use std::time::Instant;

use rayon::prelude::*;
use serde_json::{Value, json};
use thiserror::Error;

use crate::cli::args::{FileFormat, RunArguments};
use crate::cli::execute::{Outcome, scenario};
use crate::cli::interrupt::{self, Patient, Signal};
use crate::cli::layout;
use crate::cli::output::{print, print_json, remark};
use crate::cli::progress::Progress;
use crate::cli::report::Report;
use crate::cli::space::{self, NoRoom};
use crate::cli::threads::{self, NoThreads};
use crate::propagation::PropagationError;
use crate::recording::live::LiveViewer;
use crate::recording::picture::Picture;
use crate::recording::{Interruption, PartFile, Recorder, RecordingError, Subject};
use crate::scenario::{Plan, ScenarioError, library};
use crate::study::certify_body;

/// Why a scene was not run to its end.
#[derive(Debug, Error)]
enum RunError {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error("cannot measure the checks: {0}")]
    Checks(#[from] PropagationError),
    #[error("cannot certify the motion: {0}")]
    Certificate(PropagationError),
    #[error("cannot make the folder {path}: {source}", path = path.display())]
    Folder { path: PathBuf, source: io::Error },
    #[error(transparent)]
    NoRoom(#[from] NoRoom),
    #[error(transparent)]
    NoThreads(#[from] NoThreads),
    #[error("{signal}: {words}", words = stopped(*end, parts))]
    Interrupted {
        signal: Signal,
        /// How far it was recorded, if it had begun.
        end: Option<Interruption>,
        parts: Vec<PathBuf>,
    },
    #[error("two scenes are called {0:?}: their recordings would have one name")]
    SameName(String),
}

/// Runs scenes side by side and reports in the order in which they were asked for.
pub fn execute(arguments: &RunArguments) -> io::Result<Outcome> {
    let plans = match plans(arguments) {
        Ok(plans) => plans,
        Err(error) => return Ok(impossible(&error)),
    };
    let _patient = Patient::new();
    let progress = Progress::new(!arguments.quiet && !arguments.json);
    let record = |plan: Plan| (plan.name.clone(), record(plan, arguments, &progress));
    let results: Vec<_> = if plans.len() > 1 {
        plans.into_par_iter().map(record).collect()
    } else {
        plans.into_iter().map(record).collect()
    };
    let mut outcome = Outcome::Done;
    let mut values = Vec::new();
    for (index, (name, result)) in results.into_iter().enumerate() {
        match result {
            Ok(report) => {
                outcome = outcome.max(if report.passed() { Outcome::Done } else { Outcome::Failed });
                if arguments.json {
                    values.push(report.as_json());
                } else if !arguments.quiet {
                    print(&format!("{}{}", if index == 0 { "" } else { "\n" }, report.as_text()))?;
                }
                for missed in report.missed_tolerances() {
                    remark(&format!("{}: {missed}", report.plan.name));
                }
                for check in report.plan.outcomes.iter().filter(|check| !check.passed) {
                    remark(&format!("{}: check failed: {}", report.plan.name, check.name));
                }
            }
            Err(RunError::Interrupted { signal, end, parts }) => {
                outcome = Outcome::Interrupted(signal);
                let words = stopped(end, &parts);
                remark(&format!("{name}: {signal}: {words}"));
                values.push(json!({
                    "name": name,
                    "interrupted": words,
                    "samples": end.map(|end| end.samples),
                    "to_s": end.map(|end| end.to_s),
                    "parts": parts.iter().map(|part| part.display().to_string()).collect::<Vec<_>>(),
                }));
            }
            Err(error) => {
                outcome = outcome.max(impossible(&error));
                values.push(json!({ "name": name, "error": error.to_string() }));
            }
        }
    }
    if arguments.json {
        print_json(&Value::Array(values))?;
    }
    Ok(outcome)
}

fn impossible(error: &RunError) -> Outcome {
    remark(&format!("error: {error}"));
    Outcome::Impossible
}

/// Every scene planned before any is run: a mistake in the last must not cost the time of the first.
fn plans(arguments: &RunArguments) -> Result<Vec<Plan>, RunError> {
    let assignments = arguments.overrides.assignments();
    let names: Vec<String> =
        if arguments.all { library::names().map(str::to_owned).collect() } else { arguments.scenes.clone() };
    let mut plans: Vec<Plan> = Vec::new();
    for name in &names {
        let plan = Plan::new(&scenario(name, &assignments)?)?;
        if plans.iter().any(|other| other.name == plan.name) {
            return Err(RunError::SameName(plan.name));
        }
        plans.push(plan);
    }
    if !arguments.formats().is_empty() {
        std::fs::create_dir_all(&arguments.out)
            .map_err(|source| RunError::Folder { path: arguments.out.clone(), source })?;
        space::check(&plans, arguments.formats(), &arguments.out)?;
    }
    if plans.len() > 1 {
        threads::start()?;
    }
    Ok(plans)
}

/// Names are claimed first: one that is taken must not cost the time of checks and certificates.
fn record(plan: Plan, arguments: &RunArguments, progress: &Progress) -> Result<Report, RunError> {
    go_on()?;
    let layout = layout_file(&plan, arguments)?;
    let path = |format: &FileFormat| arguments.out.join(format!("{}.{}", plan.name, format.extension()));
    let paths: Vec<PathBuf> = arguments.formats().iter().map(path).collect();
    let files = Recorder::claim(&paths, arguments.force)?;
    let mut plan = plan.checked()?;
    go_on()?;
    if arguments.certify {
        for body in &mut plan.bodies {
            body.certificate = Some(certify_body(body, &plan.grid).map_err(RunError::Certificate)?);
            go_on()?;
        }
    }
    let started = Instant::now();
    let bar = progress.bar(&plan.name, plan.grid.len());
    let picture = arguments.draws().then(|| Picture::of(&plan)).transpose().map_err(RecordingError::from)?;
    let subject = picture.as_ref().map_or_else(|| Subject::of(&plan), |picture| Subject::drawn(&plan, picture));
    let viewer = arguments.live.as_ref().map(|address| LiveViewer::connect(&subject, address));
    let mut viewer = viewer.transpose()?;
    let mut recorder = Recorder::begin(&subject, files)?;
    let mut run = plan.start()?;
    while let Some(samples) = run.next_batch()? {
        recorder.write(samples)?;
        viewer.as_mut().map_or(Ok(()), |viewer| viewer.write(samples))?;
        bar.inc(samples.len() as u64);
        // After the last batch the run is as good as done.
        if let Some(signal) = interrupt::signal().filter(|_| run.fraction() < 1.0) {
            bar.finish_and_clear();
            let (end, parts) = recorder.interrupt()?;
            return Err(RunError::Interrupted { signal, end: Some(end), parts });
        }
    }
    let effort = run.effort();
    let files = recorder.finish()?;
    viewer.map_or(Ok(()), LiveViewer::finish)?;
    if let Some(file) = layout {
        layout::write(&plan, file)?;
    }
    bar.finish_and_clear();
    let wall = started.elapsed();
    drop(run);
    Ok(Report { plan, files, effort, wall })
}

/// Refuses to begin what comes next if a signal has come.
fn go_on() -> Result<(), RunError> {
    match interrupt::signal() {
        Some(signal) => Err(RunError::Interrupted { signal, end: None, parts: Vec::new() }),
        None => Ok(()),
    }
}

/// What there is of a run that was stopped, in words.
fn stopped(end: Option<Interruption>, parts: &[PathBuf]) -> String {
    let Some(end) = end.filter(|_| !parts.is_empty()) else { return "interrupted: nothing is recorded".to_owned() };
    let names: Vec<_> = parts.iter().map(|part| part.display().to_string()).collect();
    format!("interrupted: {} in {}; `polhode recover` makes a recording of each", end.in_words(), names.join(", "))
}

/// The layout beside an `.mcap`, made before anything is written so that a name that is taken leaves nothing behind.
fn layout_file(plan: &Plan, arguments: &RunArguments) -> Result<Option<PartFile>, RecordingError> {
    if !arguments.formats().contains(&FileFormat::Mcap) {
        return Ok(None);
    }
    PartFile::create(&arguments.out.join(format!("{}.layout.json", plan.name)), arguments.force).map(Some)
}
