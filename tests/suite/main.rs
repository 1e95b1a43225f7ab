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
#[cfg(feature = "serde")]
mod scenarios;
mod csv_format;
mod faults;
#[cfg(feature = "mcap")]
mod mcap_format;
mod planned;
#[cfg(feature = "rerun")]
mod rerun_format;
