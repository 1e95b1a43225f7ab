//! Where in a scene's text a key stands.

#[cfg(not(feature = "serde"))]
mod disabled;
#[cfg(feature = "serde")]
mod enabled;

#[cfg(not(feature = "serde"))]
pub use disabled::locate;
#[cfg(feature = "serde")]
pub use enabled::locate;
