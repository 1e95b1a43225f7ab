//! What a scene's checks ask for, held against its bodies.

mod channel;
mod motion;
mod plan;

pub use plan::plan;
