//! Numbers as text: one line a sample, whatever stands between the columns, however they are called.

mod assemble;
mod columns;
mod digits;
mod fields;
mod guess;
mod head;
mod read;

#[cfg(feature = "rerun")]
pub(in crate::recording) use assemble::{Numbers, Parts};
#[cfg(feature = "rerun")]
pub(in crate::recording) use columns::Columns;
pub(super) use read::{is_own, observe};
