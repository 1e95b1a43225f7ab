//! `polhode verify`.

mod bodies;
mod execute;
mod json;
mod text;

pub use execute::execute;
