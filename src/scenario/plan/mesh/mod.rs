//! Meshes from files, or word that this build reads none.

#[cfg(not(feature = "serde"))]
mod disabled;
#[cfg(feature = "serde")]
mod enabled;

#[cfg(not(feature = "serde"))]
pub use disabled::plan;
#[cfg(feature = "serde")]
pub use enabled::plan;
