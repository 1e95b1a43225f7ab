#![allow(missing_docs)]

mod equivalence;
#[cfg(feature = "serde")]
mod mesh_files;
mod particles;
