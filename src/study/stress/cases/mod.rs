//! Motions that methods break on, as scenes.

mod case;
mod forced;
mod free;

pub use case::{Case, Depth, cases};
