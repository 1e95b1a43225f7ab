use std::fmt::Write as _;
use std::path::PathBuf;

use sha2::{Digest as _, Sha256};

use crate::comparison::digest;

/// The hash of the values of recordings, in their order: of lines with the digest of each and the scene's name. `None` where
/// one cannot be read.
pub fn of(recordings: impl Iterator<Item = PathBuf>) -> Option<String> {
    let mut lines = String::new();
    for path in recordings {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        // Writing to a string cannot fail.
        let _ = writeln!(lines, "{}  {name}", digest(&path).ok()?.sha256);
    }
    Some(format!("{:x}", Sha256::digest(lines)))
}
