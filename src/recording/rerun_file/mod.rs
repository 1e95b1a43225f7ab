//! `.rrd`, the file that the Rerun viewer opens: exact columns to plot and read back, a moving picture, a layout.
//!
//! Written with Rerun's own building blocks, not its SDK: every error of the disk is returned, and the same plan gives
//! the same bytes in every process. Without the feature `rerun` every call says so.

#[cfg(not(feature = "rerun"))]
mod disabled;
#[cfg(feature = "rerun")]
mod enabled;

#[cfg(not(feature = "rerun"))]
pub use disabled::{RerunFile, contents};
#[cfg(feature = "rerun")]
pub use enabled::{RerunFile, contents};

#[cfg(not(feature = "rerun"))]
pub(super) use disabled::{observe, open, write_overlay};
#[cfg(feature = "live")]
pub(super) use enabled::RerunStream;
#[cfg(feature = "rerun")]
pub(super) use enabled::{observe, open, write_overlay};
