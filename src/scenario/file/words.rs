//! What the parser says, in the words of this program.

use crate::scenario::nearest;

/// How the parser begins to say that a table lacks a key.
pub const MISSING: &str = "missing field `";

/// Path and message of a fault at `key`, of which the parser says `message`.
pub fn reworded(key: &str, message: &str) -> (String, String) {
    if let Some(name) = message.strip_prefix(MISSING).and_then(|rest| rest.strip_suffix('`')) {
        let dot = if key.is_empty() { "" } else { "." };
        return (format!("{key}{dot}{name}"), "missing: it cannot be left out".to_owned());
    }
    let reworded = unknown(message, "unknown field `", |_| "no such key".to_owned())
        .or_else(|| unknown(message, "unknown variant `", |word| format!("{word:?} is not known")));
    (key.to_owned(), reworded.unwrap_or_else(|| message.to_owned()))
}

/// ``unknown field `a`, expected one of `b`, `c` ``, or of another beginning.
fn unknown(message: &str, beginning: &str, told: impl Fn(&str) -> String) -> Option<String> {
    // What was met may hold any letters; the names known do not.
    let (word, expected) = message.strip_prefix(beginning)?.rsplit_once("`, expected ")?;
    let names: Vec<_> = expected.split('`').skip(1).step_by(2).collect();
    Some(format!("{}{}", told(word), hint(word, &names)))
}

/// `; did you mean …?`, or what there is.
fn hint(word: &str, names: &[&str]) -> String {
    match nearest(word, names.iter().copied()) {
        Some(near) => format!("; did you mean `{near}`?"),
        None => format!("; here are {}", names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_misses_are_named_and_what_there_is_where_none_is_near() {
        let said = |message| reworded("a", message).1;
        assert_eq!(said("unknown field `siz`, expected one of `size`, `rate`"), "no such key; did you mean `size`?");
        assert_eq!(said("unknown field `xyzzy`, expected `size` or `rate`"), "no such key; here are `size`, `rate`");
        assert_eq!(said("unknown field `a`, expected `b`, expected `rate`"), "no such key; here are `rate`");
        assert_eq!(said("unknown variant `rk5`, expected `rk4`"), "\"rk5\" is not known; did you mean `rk4`?");
        assert_eq!(reworded("a[0]", "missing field `b`").0, "a[0].b");
        assert_eq!(said("invalid type"), "invalid type");
    }
}
