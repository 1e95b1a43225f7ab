use toml::de::{DeArray, DeTable, DeValue};

use crate::scenario::{Excerpt, Key, Segment};

/// The line of `text` where `key` stands, or where the innermost table stands that ought to hold it.
#[must_use]
pub fn locate(text: &str, key: &Key) -> Option<Excerpt> {
    let root = DeTable::parse(text).ok()?;
    let mut found = None;
    let (mut table, mut array): (Option<&DeTable<'_>>, Option<&DeArray<'_>>) = (Some(root.get_ref()), None);
    for segment in key.segments() {
        let value = match segment {
            Segment::Field(field) => table.and_then(|table| table.get(*field)),
            Segment::Index(index) => array.and_then(|array| array.get(*index)),
        };
        let Some(value) = value else { break };
        found = Some(value.span());
        (table, array) = match value.get_ref() {
            DeValue::Table(table) => (Some(table), None),
            DeValue::Array(array) => (None, Some(array)),
            _ => (None, None),
        };
    }
    found.map(|span| Excerpt::of(text, span.start, span.end))
}
