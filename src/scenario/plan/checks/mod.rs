//! What a scene's checks ask for, held against its bodies.

mod channel;
mod motion;
mod particles;
mod plan;

pub use plan::plan;
