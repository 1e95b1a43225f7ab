//! From recording to recording: any format into any other, and what a killed run left into a whole file.
//!
//! A recording that carries its scene is planned anew from it, so that the new file has pictures, layout and log, and the
//! bytes that a run to that format gives. Without a scene that fits, all columns and words are kept, and nothing is drawn.

mod convert;
mod fit;
mod plain;
mod recover;
mod scene;
mod shorten;

pub use convert::Conversion;
pub use recover::{Recovered, recover};
pub(crate) use scene::plan as carried_scene;
