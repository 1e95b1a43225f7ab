//! What was asked ([`Scenario`]), what will be done ([`Plan`]), what is happening ([`Run`]).

mod grid;
mod planned;
mod run;
mod scene;

pub use grid::Grid;
pub use planned::{Event, Path, Plan, PlannedBody};
pub use run::{Run, nanoseconds};
pub use scene::*;
