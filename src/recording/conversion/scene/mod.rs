//! The plan of a scene that a recording carries, or word that this build reads no scenes.

#[cfg(not(feature = "serde"))]
mod disabled;
#[cfg(feature = "serde")]
mod enabled;

#[cfg(not(feature = "serde"))]
pub use disabled::plan;
#[cfg(feature = "serde")]
pub use enabled::plan;
