//! The byte level of MCAP: records, chunks of them compressed in one piece, indexes.
//!
//! The `mcap` crate's writer hands its compressor a few bytes at a time, which costs as much as the compression; here a
//! chunk is laid out in memory and compressed whole. A test holds the records against those of that writer.

mod chunk;
mod ending;
mod output;
mod record;
#[cfg(test)]
mod tests;

pub(super) use output::{Output, Topic};
