//! Work-precision diagrams, `.svg` and `.png`.

mod draw;
mod legend;
mod panel;
mod scale;

pub use draw::{Format, draw};
