use std::collections::BTreeMap;
use std::path::Path;

use crate::recording::{Heading, RecordingError, Subject, Survey, subject};

/// What is recorded where no scene is known: the columns, and every word there is.
///
/// # Errors
/// If a body's name is none that a recording can have.
pub fn plain(
    path: &Path,
    survey: &Survey,
    facts: BTreeMap<String, String>,
) -> Result<Subject<'static>, RecordingError> {
    let is_word = |name: &str| {
        let is_fit = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
        !name.is_empty() && name.len() <= 64 && name.chars().all(is_fit)
    };
    // A body, or a body and a point of it.
    let is_fit = |name: &str| name.split_once('/').map_or_else(|| is_word(name), |(a, b)| is_word(a) && is_word(b));
    if let Some(body) = survey.heading.bodies.iter().find(|body| !is_fit(&body.name)) {
        let rule = format!("a body is called {:?}: at most 64 letters, digits, _ and -", body.name);
        return Err(RecordingError::NotRepresentable { path: path.into(), rule });
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let provenance: Vec<_> = facts.into_iter().collect();
    let heading = Heading { provenance, ..survey.heading.clone() };
    Ok(Subject {
        name: heading.fact("scene").unwrap_or(&stem).to_owned(),
        title: heading.fact("title").unwrap_or(&stem).to_owned(),
        identity: format!("{:?}\n{:?}\n{:?}", heading.provenance, survey.sampling(), survey.ranges),
        sampling: survey.sampling(),
        heading,
        drawing: None,
        is_compact: false,
    })
}

/// What is known of a recording, and that it comes from the file `path`.
pub fn converted(path: &Path, survey: &Survey) -> BTreeMap<String, String> {
    let heading = &survey.heading;
    let mut facts = subject::conventions();
    facts.extend(heading.provenance.iter().cloned());
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let before = heading.fact("converted_from").map(|before| format!(", from {before}")).unwrap_or_default();
    facts.insert("converted_from".into(), format!("{file}{before}"));
    facts.insert("converted_by".into(), concat!("polhode ", env!("CARGO_PKG_VERSION")).into());
    facts.insert("samples".into(), survey.sampling().samples.to_string());
    facts
}
