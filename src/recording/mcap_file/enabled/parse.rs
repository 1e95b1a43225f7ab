use std::io::Error;

use mcap::records::{Record, op};
use mcap::{McapError, McapResult, parse_record};

/// What comes before the last text of a record, as far as its lengths go.
enum Field {
    /// So many bytes.
    Bytes(usize),
    /// A length of four bytes, and a text.
    Text,
    /// A length of four bytes, and bytes.
    Block,
    /// A length of four bytes, and pairs of texts.
    Texts,
}

/// The record of this kind with these fields. The crate's parser makes room for a text by its length, up to 4 GiB,
/// before it looks whether it is there: so that is looked at first.
///
/// # Errors
/// If a text is longer than its record, or the record of another form than its kind.
pub(super) fn parse(opcode: u8, body: &[u8]) -> McapResult<Record<'_>> {
    check(opcode, body)?;
    parse_record(opcode, body)
}

/// Holds the lengths of all texts in a record against what is there.
///
/// # Errors
/// If one is longer.
fn check(opcode: u8, body: &[u8]) -> McapResult<()> {
    let mut rest = body;
    let holds = fields(opcode).iter().all(|field| pass(field, &mut rest).is_some());
    if holds { Ok(()) } else { Err(McapError::Io(Error::other("a record has a text that is longer than it is"))) }
}

const fn fields(opcode: u8) -> &'static [Field] {
    use Field::{Block, Bytes, Text, Texts};
    match opcode {
        op::HEADER => &[Text, Text],
        op::SCHEMA => &[Bytes(2), Text, Text],
        op::CHANNEL => &[Bytes(4), Text, Text, Texts],
        op::CHUNK => &[Bytes(28), Text],
        op::CHUNK_INDEX => &[Bytes(32), Block, Bytes(8), Text],
        op::ATTACHMENT => &[Bytes(16), Text, Text],
        op::ATTACHMENT_INDEX => &[Bytes(40), Text, Text],
        op::METADATA => &[Text, Texts],
        op::METADATA_INDEX => &[Bytes(16), Text],
        _ => &[],
    }
}

/// Goes past a field; `None` if it is not all there.
fn pass(field: &Field, rest: &mut &[u8]) -> Option<()> {
    match field {
        Field::Bytes(count) => *rest = rest.get(*count..)?,
        Field::Text | Field::Block => {
            let length = length(rest)?;
            *rest = rest.get(length..)?;
        }
        Field::Texts => {
            let length = length(rest)?;
            let (mut pairs, after) = rest.split_at_checked(length)?;
            *rest = after;
            while !pairs.is_empty() {
                pass(&Field::Text, &mut pairs)?;
                pass(&Field::Text, &mut pairs)?;
            }
        }
    }
    Some(())
}

/// The length that `rest` begins with, and goes past it.
fn length(rest: &mut &[u8]) -> Option<usize> {
    let (length, after) = rest.split_first_chunk::<4>()?;
    *rest = after;
    usize::try_from(u32::from_le_bytes(*length)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_that_are_only_claimed_are_not_made_room_for() {
        let claims: [(u8, &[u8]); 6] = [
            (op::HEADER, b"\xff\xff\xff\xff"),
            (op::SCHEMA, b"\x01\0\x01\0\0\0a\xff\xff\xff\x7f"),
            (op::CHANNEL, b"\x01\0\x01\0\x01\0\0\0t\0\0\0\0\x08\0\0\0\0\0\0\0\xff\xff\xff\xff"),
            (op::CHANNEL, b"\x01\0\x01\0\x01\0\0\0t\0\0\0\0\xff\xff\xff\xff\0\0\0\0"),
            (op::METADATA, b"\0\0\0\0\x05\0\0\0\x01\0\0\0k"),
            (op::METADATA_INDEX, b"0123456789abcdef\xff\xff\xff\xff"),
        ];
        for (opcode, body) in claims {
            let refused = parse(opcode, body);
            assert!(
                matches!(&refused, Err(McapError::Io(error)) if error.to_string().contains("longer than it is")),
                "{opcode}: {refused:?}"
            );
        }
        let whole = b"\x01\0\x01\0\x01\0\0\0t\0\0\0\0\x0a\0\0\0\x01\0\0\0k\x01\0\0\0v";
        assert!(matches!(parse(op::CHANNEL, whole), Ok(Record::Channel(channel)) if channel.metadata["k"] == "v"));
    }
}
