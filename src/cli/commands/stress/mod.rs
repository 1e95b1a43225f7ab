//! `polhode stress`: every method against the motions that break methods.

mod execute;
mod json;
mod matrix;
mod plot;
mod view;

pub use execute::execute;
