//! Are two recordings the same motion? Is one of them true?

pub mod verify;
