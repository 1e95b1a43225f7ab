use std::fmt::Write as _;
use std::io::Write;

use re_sdk_types::archetypes::{RecordingInfo, TextDocument};
use re_sdk_types::blueprint::components::ContainerKind;

use super::blueprint::{Blueprint, Container, View};
use super::plot_views;
use super::stream::{Store, Stream};
use crate::recording::{RecordingError, Subject};

/// The layout of a recording whose scene is not known: words beside plots.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write_layout<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    subject: &Subject,
) -> Result<(), RecordingError> {
    let mut blueprint = Blueprint::new(stream, store);
    let contents = ["/about".to_owned()];
    let about = View { class: "TextDocument", name: "What this is", origin: "/about", contents: &contents };
    let about = blueprint.view(&about)?;
    let plots = plot_views::write(&mut blueprint, &subject.heading.bodies, subject.sampling, None)?;
    let parts: Vec<_> = [Some(about), plots].into_iter().flatten().collect();
    let shares = &[2.0, 5.0][..parts.len()];
    let root = Container { kind: ContainerKind::Horizontal, name: "", parts: &parts, shares };
    let root = blueprint.container(&root)?;
    blueprint.root(&root, subject.sampling.playback_speed())
}

/// What is known of it, in words.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write<W: Write>(stream: &mut Stream<W>, store: Store, subject: &Subject) -> Result<(), RecordingError> {
    if !subject.is_compact {
        stream.once(store, "/about", &[], &document(subject))?;
    }
    stream.once(store, "/__properties", &[], &RecordingInfo::new().with_name(subject.title.as_str()))
}

fn document(subject: &Subject) -> TextDocument {
    let mut text = format!("### {}\n\nColumns without pictures: the scene is not known here.\n", subject.title);
    text += "\n#### Bodies\n\n";
    for body in &subject.heading.bodies {
        let channels: Vec<_> = body.channels.iter().map(|channel| channel.row().title).collect();
        let _ = writeln!(text, "- **{}**: {}", body.name, channels.join("; "));
    }
    text += "\n#### Provenance\n\n";
    for (name, value) in &subject.heading.provenance {
        let _ = writeln!(text, "- **{}**: {}", plain(name), plain(value));
    }
    TextDocument::from_markdown(text)
}

/// On one line, as it is: nothing in it is a mark of the language that the panel is written in.
fn plain(text: &str) -> String {
    let is_mark = |letter: char| letter.is_ascii_punctuation() && !"-.,:;/()".contains(letter);
    let words = text.replace(['\n', '\r'], " ");
    words.chars().flat_map(|letter| is_mark(letter).then_some('\\').into_iter().chain([letter])).collect()
}
