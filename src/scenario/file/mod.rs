//! Scenes from TOML text, with overrides.

mod assign;
mod parse;
mod read;
mod words;
