//! The program: asks, shows, exits.
//!
//! Results go to stdout, progress and remarks to stderr. Exit codes: 0 done or same, 1 a check failed or recordings differ, 2 could not,
//! 130 and 143 interrupted.

mod args;
mod commands;
mod execute;
mod folder;
mod growth;
mod interrupt;
mod layout;
mod names;
mod output;
mod progress;
mod report;
mod source;
mod space;
mod table;
mod threads;

pub use args::Arguments;
pub use execute::{asked, execute};
