//! Formulae from text, or word that this build reads none.

#[cfg(not(feature = "serde"))]
mod disabled;
#[cfg(feature = "serde")]
mod enabled;

#[cfg(not(feature = "serde"))]
pub(super) use disabled::read;
#[cfg(feature = "serde")]
pub(super) use enabled::read;
