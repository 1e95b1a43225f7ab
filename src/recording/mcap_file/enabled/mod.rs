//! Written in this order: metadata, scene text, schemas and channels, the surfaces and the start, then sample after sample.

mod about;
mod container;
mod descriptor;
mod foxglove;
mod log;
mod read;
mod scan;
mod scene;
mod state;
mod summary;
mod surfaces;
mod tally;
mod write;

pub use read::contents;
pub use write::McapFile;
