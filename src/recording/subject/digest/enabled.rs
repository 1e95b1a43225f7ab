use sha2::{Digest as _, Sha256};

/// In hexadecimal digits.
#[expect(clippy::unnecessary_wraps, reason = "the same interface as without the formats that need it")]
pub fn sha256(text: &str) -> Option<String> {
    Some(format!("{:x}", Sha256::digest(text)))
}
