//! What can be asked of the program: a file or folder for each command.

pub mod bench;
pub mod check;
pub mod compare;
pub mod convert;
pub mod digest;
pub mod golden;
pub mod inspect;
pub mod list;
pub mod new;
pub mod plan;
pub mod plot;
pub mod recover;
pub mod report;
pub mod run;
pub mod schema;
pub mod stress;
pub mod verify;
pub mod view;
