//! SHA-256, which the formats with words in them bring along.

#[cfg(not(any(feature = "mcap", feature = "rerun")))]
mod disabled;
#[cfg(any(feature = "mcap", feature = "rerun"))]
mod enabled;

#[cfg(not(any(feature = "mcap", feature = "rerun")))]
pub use disabled::sha256;
#[cfg(any(feature = "mcap", feature = "rerun"))]
pub use enabled::sha256;
