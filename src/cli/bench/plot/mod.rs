//! Work-precision diagrams, `.svg` and `.png`.

mod draw;
mod panel;
mod scale;

pub use draw::draw;
