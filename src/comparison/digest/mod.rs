//! The SHA-256 of what a recording holds, whatever holds it.

mod content;

pub use content::{Digest, digest};
