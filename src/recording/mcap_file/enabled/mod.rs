//! Written in this order: metadata, scene text, schemas and channels, the surfaces and the start, then sample after sample.

mod about;
mod columns;
mod container;
mod descriptor;
mod foreign;
mod foxglove;
mod intake;
mod log;
mod parse;
mod read;
mod scan;
mod scene;
mod state;
mod summary;
mod surfaces;
mod tally;
mod template;
mod unpack;
mod write;

pub(in crate::recording) use columns::open;
pub(in crate::recording) use foreign::observe;
pub use read::contents;
pub use write::McapFile;
