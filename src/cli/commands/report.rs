use std::path::PathBuf;

use thiserror::Error;

use crate::cli::args::ReportArguments;
use crate::cli::execute::{Outcome, ended};
use crate::cli::interrupt::Patient;
use crate::cli::output::{remark, write};
use crate::cli::source::{Named, Source, SourceError};
use crate::plot::{Motion, Page, PlotError, Request};
use crate::recording::{PartFile, RecordingError};

/// Why there is no page.
#[derive(Debug, Error)]
enum ReportError {
    #[error(transparent)]
    Source(#[from] SourceError),
    #[error(transparent)]
    Plot(#[from] PlotError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error("cannot write {path}: a page's name ends in .html", path = .0.display())]
    NoPage(PathBuf),
}

/// Makes one page of a recording or a scene.
pub fn execute(arguments: &ReportArguments) -> Outcome {
    let _patient = Patient::new();
    report(arguments).unwrap_or_else(|error| ended(&error))
}

fn report(arguments: &ReportArguments) -> Result<Outcome, ReportError> {
    if arguments.output.extension().is_none_or(|extension| extension != "html") {
        return Err(ReportError::NoPage(arguments.output.clone()));
    }
    let scene = &arguments.scene;
    let named = Named { what: &arguments.what, scene: scene.scene.as_deref(), set: &scene.set, channels: &[] };
    let file = PartFile::create(&arguments.output, arguments.force)?;
    let source = Source::open(&named)?.measured(arguments.certify)?;
    let (heading, sampling) = (source.heading(), source.sampling());
    let mut motion = Motion::new(&heading, source.plan(), &Request::default())?;
    source.read(&mut |samples| motion.add(samples))?;
    let mut remarks = motion.remarks();
    remarks.extend(source.remark().map(|reason| format!("checks and pictures of the body: {reason}")));
    let page = Page {
        title: &source.title(),
        source: &arguments.what,
        heading: &heading,
        sampling,
        plan: source.plan(),
        motion: &motion,
        remarks: &remarks,
        commands: &commands(arguments, &source),
    };
    write(file, page.html().as_bytes())?;
    let outcomes = source.plan().map(|plan| plan.outcomes.as_slice()).unwrap_or_default();
    let failures: Vec<_> = outcomes.iter().filter(|check| !check.passed).map(|check| &check.name).collect();
    for name in &failures {
        remark(&format!("{}: check failed: {name}", arguments.what));
    }
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failed })
}

/// What was typed, and what makes the recording.
fn commands(arguments: &ReportArguments, source: &Source) -> Vec<String> {
    let quoted = |word: &str| {
        let is_plain = |letter: char| letter.is_alphanumeric() || "._-/=+,:".contains(letter);
        if !word.is_empty() && word.chars().all(is_plain) {
            word.to_owned()
        } else {
            format!("'{}'", word.replace('\'', "'\\''"))
        }
    };
    let scene = arguments.scene.scene.iter().map(|scene| format!(" --scene {}", quoted(scene)));
    let set = arguments.scene.set.iter().map(|set| format!(" --set {}", quoted(set)));
    let rest: String = scene.chain(set).collect();
    let what = quoted(&arguments.what);
    let certify = if arguments.certify { " --certify" } else { "" };
    let output = quoted(&arguments.output.display().to_string());
    let page = format!("polhode report {what}{rest}{certify} -o {output}");
    match source {
        Source::Scene(_) => vec![format!("polhode run {what}{rest}{certify}"), page],
        Source::Recording(..) if source.heading().scene.is_some() => {
            let name = source.heading().fact("scene").unwrap_or("scene").to_owned();
            let toml = quoted(&format!("{name}.toml"));
            vec![format!("polhode run {toml}   # the scene below, saved under that name"), page]
        }
        Source::Recording(..) => vec![page],
    }
}
