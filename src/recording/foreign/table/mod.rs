//! Numbers as text: one line a sample, whatever stands between the columns, however they are called.

mod assemble;
mod columns;
mod digits;
mod fields;
mod guess;
mod head;
mod read;

pub(super) use read::{is_own, observe};
