use std::io;

use serde_json::json;

use super::bodies::Bodies;
use super::{json, text};
use crate::cli::args::VerifyArguments;
use crate::cli::execute::Outcome;
use crate::cli::output::{print, print_json, remark};
use crate::comparison::verify::{Verdict, Verification, verify};
use crate::recording::RecordingError;
use crate::recording::foreign::{Mapping, Observation, observe};

/// Holds what a recording says of rotations against physics.
pub fn execute(arguments: &VerifyArguments) -> io::Result<Outcome> {
    let found = match found(arguments) {
        Ok(found) => found,
        Err(message) => {
            remark(&format!("error: {message}"));
            return Ok(Outcome::Impossible);
        }
    };
    let Found { observation, source, verifications } = &found;
    let file = arguments.file.display().to_string();
    if arguments.json {
        let bodies: Vec<_> = verifications.iter().map(json::of).collect();
        let remarks = &observation.remarks;
        print_json(&json!({ "file": file, "held_against": source, "remarks": remarks, "bodies": bodies }))?;
    } else {
        let texts: Vec<_> = verifications.iter().map(|one| text::of(&file, source.as_deref(), one)).collect();
        print(&(texts.join("\n") + &text::remarks(&observation.remarks)))?;
    }
    Ok(verifications.iter().map(|one| outcome(one.verdict)).max().unwrap_or(Outcome::Impossible))
}

struct Found {
    observation: Observation,
    /// Where the bodies come from.
    source: Option<String>,
    verifications: Vec<Verification>,
}

fn outcome(verdict: Verdict) -> Outcome {
    match verdict {
        Verdict::Clean => Outcome::Done,
        Verdict::Wrong => Outcome::Failed,
        Verdict::CannotTell => Outcome::Impossible,
    }
}

fn found(arguments: &VerifyArguments) -> Result<Found, String> {
    if !(arguments.tolerance > 0.0 && arguments.tolerance.is_finite()) {
        return Err(format!("--tolerance {}: it must be positive and finite", arguments.tolerance));
    }
    for (flag, given, wanted) in
        [("--principal-moments", arguments.principal_moments.len(), 3), ("--inertia", arguments.inertia.len(), 6)]
    {
        if given != 0 && given != wanted {
            return Err(format!("{flag}: {given} numbers, where it takes {wanted}"));
        }
    }
    let mapping = mapping(arguments)?;
    let observation = observe(&arguments.file, &mapping).map_err(|error: RecordingError| error.to_string())?;
    let bodies = Bodies::of(arguments).map_err(|error| error.to_string())?;
    let wanted: Vec<_> = observation
        .bodies
        .iter()
        .filter(|observed| arguments.body.as_ref().is_none_or(|name| *name == observed.name))
        .collect();
    if wanted.is_empty() {
        let names: Vec<_> = observation.bodies.iter().map(|observed| observed.name.as_str()).collect();
        let name = arguments.body.as_deref().unwrap_or_default();
        return Err(format!("there is no body {name:?} in the file: there is {}", names.join(", ")));
    }
    let mut verifications = Vec::new();
    for observed in &wanted {
        let body = bodies.find(observed, wanted.len());
        if body.is_none() && bodies.source.is_some() {
            let name = &observed.name;
            return Err(format!("{name}: which body it is to be held against is not known; choose with --body"));
        }
        let resolution = observation.time_resolution_s;
        verifications.push(verify(observed, body, resolution, arguments.tolerance).map_err(|error| error.to_string())?);
    }
    Ok(Found { source: bodies.source, verifications, observation })
}

fn mapping(arguments: &VerifyArguments) -> Result<Mapping, String> {
    match (&arguments.map, &arguments.columns) {
        (Some(path), _) => Mapping::read(path).map_err(|error| error.to_string()),
        (None, Some(columns)) => Mapping::of_columns(columns).map_err(|error| format!("--columns: {error}")),
        (None, None) => Ok(Mapping::default()),
    }
}
