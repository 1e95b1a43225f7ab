use std::io::Write;

use re_sdk_types::archetypes::TextDocument;

use super::stream::{Store, Stream};
use crate::recording::{RecordedBody, RecordingError, Subject};
use crate::telemetry::Channel;

/// Entity of the scene's text, where it is known.
pub(super) const SCENE: &str = "/scene";

/// Entity of what made the recording, from what, how: a fact a line, for programs.
pub(super) const PROVENANCE: &str = "/provenance";

/// Entity of a compact recording's bodies and their channels: `name: channel, channel` on a line each.
pub(super) const COLUMNS: &str = "/columns";

/// Logs where the recording comes from.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write<W: Write>(stream: &mut Stream<W>, store: Store, subject: &Subject) -> Result<(), RecordingError> {
    if let Some(scene) = &subject.heading.scene {
        stream.once(store, SCENE, &[], &TextDocument::new(scene.as_str()))?;
    }
    stream.once(store, PROVENANCE, &[], &TextDocument::new(lines(&subject.heading.provenance)))
}

/// Entity that tells that there is a body, or a point of one, of that name, whether anything is recorded of it or not.
pub(super) fn body(name: &str) -> String {
    format!("/body/{name}")
}

/// The body, or the point of one, that `entity` tells of.
pub(super) fn body_of(entity: &str) -> Option<&str> {
    entity.strip_prefix("/body/").filter(|name| name.matches('/').count() < 2)
}

/// Which bodies there are, and which channels of them, in their order.
pub(super) fn columns(bodies: &[RecordedBody]) -> String {
    let channels = |body: &RecordedBody| body.channels.iter().map(|channel| channel.row().name).collect::<Vec<_>>();
    let line = |body: &RecordedBody| format!("{}: {}\n", body.name, channels(body).join(", "));
    bodies.iter().map(line).collect()
}

/// The bodies with their channels that such lines tell.
///
/// # Errors
/// If they are no such lines.
pub(super) fn bodies(columns: &str) -> Result<Vec<(&str, Vec<Channel>)>, String> {
    let named = |name: &str| Channel::from_name(name).ok_or_else(|| format!("{COLUMNS} names {name:?}, no channel"));
    let body = |line| {
        let (name, channels) = str::split_once(line, ": ").ok_or_else(|| format!("{COLUMNS} has the line {line:?}"))?;
        let channels = channels.split(", ").filter(|name| !name.is_empty()).map(named).collect::<Result<_, _>>()?;
        Ok((name, channels))
    };
    columns.lines().map(body).collect()
}

/// By which method a body was propagated, and why, as far as `provenance` tells.
pub(super) fn method(provenance: &[(String, String)], body: &str) -> String {
    let fact = |word: &str| {
        let wanted = format!("body.{body}.{word}");
        provenance.iter().find(|(name, _)| *name == wanted).map(|(_, value)| value.as_str())
    };
    let words: Vec<_> = [fact("method"), fact("reason")].into_iter().flatten().collect();
    words.join(": ")
}

/// `name = value` on a line each, whatever is in them.
fn lines(facts: &[(String, String)]) -> String {
    let line =
        |(name, value): &(String, String)| format!("{} = {}\n", escaped(name).replace('=', "\\="), escaped(value));
    facts.iter().map(line).collect()
}

/// The facts that such lines tell; what is no such line is left.
pub(super) fn facts(lines: &str) -> Vec<(String, String)> {
    let facts = lines.split('\n').filter_map(|line| line.split_once(" = "));
    facts.map(|(name, value)| (unescaped(name), unescaped(value))).collect()
}

fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('\n', "\\n").replace('\r', "\\r")
}

fn unescaped(text: &str) -> String {
    let (mut plain, mut letters) = (String::with_capacity(text.len()), text.chars());
    while let Some(letter) = letters.next() {
        plain.push(match letter {
            '\\' => match letters.next() {
                Some('n') => '\n',
                Some('r') => '\r',
                Some(other) => other,
                None => '\\',
            },
            letter => letter,
        });
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_come_back_and_nothing_else_is_taken_for_them() {
        let body = |name: &str, channels: &[Channel]| RecordedBody {
            name: name.into(),
            channels: channels.to_vec(),
            ..RecordedBody::default()
        };
        let told = [body("a-b_1", &Channel::ALL), body("none", &[])];
        let lines = columns(&told);
        let found = bodies(&lines).expect("such lines");
        assert_eq!(found, [("a-b_1", Channel::ALL.to_vec()), ("none", Vec::new())]);
        for wrong in ["a", "a:attitude", "a: attitud", "a: attitude; tilt", "\n"] {
            assert!(bodies(wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn facts_come_back_whatever_is_in_them() {
        let told = [("a", "b"), ("title", "two\nlines = \\n\r"), ("x = y", " = "), ("", ""), ("\\=", "é")];
        let told = told.map(|(name, value)| (name.to_owned(), value.to_owned()));
        assert_eq!(facts(&lines(&told)), told);
    }
}
