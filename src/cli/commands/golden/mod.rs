//! `polhode golden`: committed recordings of scenes, held to what the scenes give now.

mod error;
mod examine;
mod execute;
mod finding;
mod plan;
mod record;
mod report;
mod values;

pub use execute::execute;
