//! A run as it happens, in a Rerun viewer that is open.
//!
//! What is sent is what an `.rrd` of the run would hold, message by message. Without the feature `live` every call says so.

#[cfg(not(feature = "live"))]
mod disabled;
#[cfg(feature = "live")]
mod enabled;

#[cfg(not(feature = "live"))]
pub use disabled::LiveViewer;
#[cfg(feature = "live")]
pub use enabled::LiveViewer;
