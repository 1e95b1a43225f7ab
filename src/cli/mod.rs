//! The program: asks, shows, exits.
//!
//! Results go to stdout, progress and remarks to stderr. Exit codes: 0 done, 1 a check failed, 2 could not.

mod args;
mod bench;
mod convert;
mod execute;
mod inspect;
mod layout;
mod list;
mod output;
mod plan;
mod progress;
mod recover;
mod report;
mod run;
mod table;
mod view;

pub use args::Arguments;
pub use execute::execute;
