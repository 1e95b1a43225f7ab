use thiserror::Error;

use crate::cli::args::PlotArguments;
use crate::cli::execute::{Outcome, ended};
use crate::cli::interrupt::Patient;
use crate::cli::output::{remark, write};
use crate::cli::source::{Named, Source, SourceError};
use crate::plot::{Format, Motion, PlotError, Request, Wanted, words};
use crate::recording::{PartFile, RecordingError};
use crate::telemetry::Channel;

/// Why there is no plot.
#[derive(Debug, Error)]
enum DrawError {
    #[error(transparent)]
    Source(#[from] SourceError),
    #[error(transparent)]
    Plot(#[from] PlotError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error("--channels: {0}")]
    Channels(String),
    #[error("no sample is from {from} to {to} s: the recording is from {first} to {last} s")]
    Nothing { from: f64, to: f64, first: f64, last: f64 },
}

/// Draws a recording or a scene.
pub fn execute(arguments: &PlotArguments) -> Outcome {
    let _patient = Patient::new();
    draw(arguments).map_or_else(|error| ended(&error), |()| Outcome::Done)
}

fn draw(arguments: &PlotArguments) -> Result<(), DrawError> {
    let format = Format::of(&arguments.output)?;
    let wanted = arguments.channels.iter().map(|name| Wanted::named(name).map_err(DrawError::Channels));
    let wanted = wanted.collect::<Result<Vec<_>, _>>()?;
    let channels: Vec<Channel> = wanted.iter().flat_map(Wanted::needs).copied().collect();
    let scene = &arguments.scene;
    let named = Named { what: &arguments.what, scene: scene.scene.as_deref(), set: &scene.set, channels: &channels };
    // The name is claimed first: one that is taken must not cost the time of a run.
    let file = PartFile::create(&arguments.output, arguments.force)?;
    let source = Source::open(&named)?;
    let request = Request { wanted, bodies: arguments.body.clone(), from_s: arguments.from, to_s: arguments.to };
    let (mut heading, sampling) = (source.heading(), source.sampling());
    let mut motion = Motion::new(&heading, source.plan(), &request)?;
    heading.bodies.retain(|body| arguments.body.is_empty() || arguments.body.contains(&body.name));
    source.read(&mut |samples| motion.add(samples))?;
    if motion.is_empty() {
        return Err(DrawError::Nothing {
            from: request.from_s.unwrap_or(sampling.from_s),
            to: request.to_s.unwrap_or(sampling.to_s),
            first: sampling.from_s,
            last: sampling.to_s,
        });
    }
    for text in source.remark().into_iter().map(str::to_owned).chain(motion.remarks()) {
        remark(&format!("{}: {text}", arguments.what));
    }
    let bytes = format.bytes(
        &motion.draw(&source.title(), &words(&heading, sampling, source.plan().and_then(|plan| plan.tolerance_rad))),
    )?;
    Ok(write(file, &bytes)?)
}
