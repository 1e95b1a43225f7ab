//! `.mcap`: for Foxglove and Lichtblick, and the archive: whatever becomes of this program, any MCAP library reads it.
//!
//! | topic | schema | rate | holds |
//! |---|---|---|---|
//! | `/tf` | `foxglove.FrameTransforms` | picture | `body/<name>` in `world` |
//! | `/scene` | `foxglove.SceneUpdate` | picture | ω, L, τ, F as arrows in `world`; every message has all of them |
//! | `/scene/surfaces` | `foxglove.SceneUpdate` | once | the bodies' surfaces, fixed in `body/<name>` |
//! | `/body/<name>/state` | `polhode.BodyState` | every sample | the exact time and every channel, as f64: the truth |
//! | `/log` | `foxglove.Log` | events | the start, and loads that begin or end |
//!
//! Viewers that seek show of each topic the last message before: so the surfaces, sent once, have a topic of their own,
//! and each message on `/scene` holds all arrows.
//!
//! Log time, publish time and timestamps are simulated time in ns from the start. The metadata record `polhode` says
//! what made the file, and how; the scene itself is attached. The same plan gives the same bytes.
//! Field numbers of `polhode.BodyState` are in `schemas/polhode.proto`; fields are only ever added.

#[cfg(not(feature = "mcap"))]
mod disabled;
#[cfg(feature = "mcap")]
mod enabled;

#[cfg(not(feature = "mcap"))]
pub use disabled::{McapFile, contents};
#[cfg(feature = "mcap")]
pub use enabled::{McapFile, contents};

#[cfg(not(feature = "mcap"))]
pub(super) use disabled::{observe, open};
#[cfg(feature = "mcap")]
pub(super) use enabled::{observe, open};
