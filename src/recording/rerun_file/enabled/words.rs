use std::io::Write;

use re_sdk_types::archetypes::TextDocument;

use super::stream::{Store, Stream};
use crate::recording::{RecordingError, Subject};

/// Entity of the scene's text, where it is known.
pub(super) const SCENE: &str = "/scene";

/// Entity of what made the recording, from what, how: a fact a line, for programs.
pub(super) const PROVENANCE: &str = "/provenance";

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

/// Entity that tells that there is a body of that name, whether anything is recorded of it or not.
pub(super) fn body(name: &str) -> String {
    format!("/body/{name}")
}

/// The body that `entity` tells of.
pub(super) fn body_of(entity: &str) -> Option<&str> {
    entity.strip_prefix("/body/").filter(|name| !name.contains('/'))
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
    fn facts_come_back_whatever_is_in_them() {
        let told = [("a", "b"), ("title", "two\nlines = \\n\r"), ("x = y", " = "), ("", ""), ("\\=", "é")];
        let told = told.map(|(name, value)| (name.to_owned(), value.to_owned()));
        assert_eq!(facts(&lines(&told)), told);
    }
}
