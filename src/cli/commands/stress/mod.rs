//! `polhode stress`: every method against the motions that break methods.

mod execute;
mod json;
mod matrix;
mod plot;

pub use execute::execute;
