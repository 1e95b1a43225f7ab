use std::io;
use std::path::Path;

use thiserror::Error;

use super::json::as_json;
use super::text::as_text;
use crate::cli::args::CompareArguments;
use crate::cli::execute::{Outcome, scenario};
use crate::cli::output::{print, print_json, remark, write};
use crate::comparison::{CompareError, Comparison, Finding, Report, Side, ToleranceError, Tolerances, channel_named};
use crate::plot::{Format, PlotError, differences};
use crate::recording::{Overlay, PartFile, RecordingError};
use crate::scenario::{Plan, ScenarioError};

/// Why nothing was compared.
#[derive(Debug, Error)]
enum Refusal {
    #[error(transparent)]
    Compare(#[from] CompareError),
    #[error(transparent)]
    Tolerance(#[from] ToleranceError),
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error(transparent)]
    Plot(#[from] PlotError),
    #[error("--body {0:?}: it reads A=B, what the body is called in A and in B")]
    Body(String),
    #[error("--{0} {1}: a finite number of seconds")]
    Time(&'static str, f64),
    #[error("--set-{0} is for a scene, and {1} is a recording")]
    SetOfRecording(&'static str, String),
}

/// Compares two motions.
pub fn execute(arguments: &CompareArguments) -> io::Result<Outcome> {
    let (comparison, report) = match compare(arguments) {
        Ok(found) => found,
        Err(error) => {
            remark(&format!("error: {error}"));
            return Ok(Outcome::Impossible);
        }
    };
    if arguments.json {
        print_json(&as_json(&comparison, &report))?;
    } else {
        print(&as_text(&comparison, &report))?;
    }
    Ok(match report.finding() {
        Finding::Same => Outcome::Done,
        Finding::Different => Outcome::Failed,
        Finding::Undecided => Outcome::Impossible,
    })
}

fn compare(arguments: &CompareArguments) -> Result<(Comparison, Report), Refusal> {
    let comparison = comparison(arguments)?;
    let plan_a = plan(&arguments.a, "a", &arguments.set_a)?;
    let plan_b = plan(&arguments.b, "b", &arguments.set_b)?;
    let sides = (side(&arguments.a, plan_a.as_ref())?, side(&arguments.b, plan_b.as_ref())?);
    // Names are claimed first: one that is taken must not cost the time of the comparison.
    let plot = arguments
        .plot
        .as_ref()
        .map(|path| Ok::<_, Refusal>((Format::of(path)?, PartFile::create(path, arguments.force)?)))
        .transpose()?;
    let report = match &arguments.record {
        None => comparison.run(sides.0, sides.1)?,
        Some(path) => {
            let file = Overlay::claim(path, arguments.force)?;
            let shapes = [sides.0.shapes(), sides.1.shapes()];
            let (report, poses) = comparison.run_with_poses(sides.0, sides.1)?;
            report.overlay(poses, &shapes).record(file)?;
            report
        }
    };
    if let Some((format, file)) = plot {
        write(file, &format.bytes(&differences(&report))?)?;
    }
    Ok((comparison, report))
}

/// What a side is planned as, if it is a scene.
fn plan(name: &str, letter: &'static str, assignments: &[String]) -> Result<Option<Plan>, Refusal> {
    if !is_recording(Path::new(name)) {
        return Ok(Some(Plan::new(&scenario(name, assignments)?)?));
    }
    if assignments.is_empty() { Ok(None) } else { Err(Refusal::SetOfRecording(letter, name.to_owned())) }
}

fn side<'a>(name: &str, plan: Option<&'a Plan>) -> Result<Side<'a>, Refusal> {
    Ok(match plan {
        Some(plan) => Side::Scene(plan),
        None => Side::open(Path::new(name))?,
    })
}

fn is_recording(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str());
    matches!(extension, Some("mcap" | "rrd" | "csv" | "part"))
}

fn comparison(arguments: &CompareArguments) -> Result<Comparison, Refusal> {
    let mut tolerances = if arguments.exact { Tolerances::exact() } else { Tolerances::default() };
    if let Some(file) = &arguments.tolerances {
        tolerances = tolerances.read(file)?;
    }
    for assignment in &arguments.tolerance {
        tolerances = tolerances.assign(assignment)?;
    }
    let names = arguments.body.iter().map(|names| {
        let (a, b) = names.split_once('=').ok_or_else(|| Refusal::Body(names.clone()))?;
        Ok((a.to_owned(), b.to_owned()))
    });
    let channels = arguments.channels.iter().map(|name| channel_named(name));
    for (name, time) in [("shift", Some(arguments.shift)), ("from", arguments.from), ("to", arguments.to)] {
        if let Some(time) = time.filter(|time| !time.is_finite()) {
            return Err(Refusal::Time(name, time));
        }
    }
    Ok(Comparison {
        tolerances,
        channels: channels.collect::<Result<_, ToleranceError>>()?,
        names: names.collect::<Result<_, Refusal>>()?,
        shift_s: arguments.shift,
        is_resampled: arguments.resample,
        from_s: arguments.from,
        to_s: arguments.to,
    })
}
