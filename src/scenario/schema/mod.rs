//! The JSON Schema of scenes, derived from the structs that mirror the file, for editors and other programs.

mod finish;
mod generate;
pub mod structure;
mod unit;

pub use generate::schema;
