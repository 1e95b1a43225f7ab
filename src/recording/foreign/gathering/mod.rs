//! What many messages say, one after the other, made into bodies.

mod bodies;
mod joining;
mod stamped;
mod statement;

pub(in crate::recording) use bodies::Gathering;
#[cfg(feature = "mcap")]
pub(in crate::recording) use bodies::MOST_BODIES;
#[cfg(feature = "rerun")]
pub(in crate::recording) use stamped::{seconds, start_of};
pub(in crate::recording) use statement::{Place, Statement};
