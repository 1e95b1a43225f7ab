//! A motion as one page of HTML, for people who have no program to look at it with.
//!
//! It is put together by `format!` with one function that escapes text, the one that SVG uses too: there is one page, and
//! a template would be a second language for it.

mod base64;
mod compose;
mod partition;
mod sections;
mod solid;
mod strobe;

pub use compose::Page;
