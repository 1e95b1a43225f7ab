//! What many messages say, one after the other, made into bodies.

mod bodies;
mod joining;
mod stamped;
mod statement;

pub(in crate::recording) use bodies::Gathering;
pub(in crate::recording) use statement::{Place, Statement};
