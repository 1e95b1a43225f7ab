//! `polhode compare`.

mod execute;
mod json;
mod text;

pub use execute::execute;
