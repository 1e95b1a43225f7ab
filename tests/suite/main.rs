#![allow(missing_docs)]

mod equivalence;
#[cfg(feature = "serde")]
mod mesh_files;
mod particles;
#[cfg(feature = "serde")]
mod bad_scenes;
#[cfg(feature = "cli")]
mod cli;
mod floors;
mod oracle;
mod reference;
mod effort;
mod forced_oracle;
mod motions;
mod order;
mod torque_laws;
mod free_laws;
mod numerics;
