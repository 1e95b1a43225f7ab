//! Samples of two sides at the same times: merged, computed or interpolated.

mod cursor;
mod follower;
mod interpolation;
mod pairs;
mod resampler;

pub(in crate::comparison) use cursor::{Cursor, Feed, Window};
pub(in crate::comparison) use follower::Follower;
pub(in crate::comparison) use pairs::{Pairs, Scene, Stretch, Way};
pub(in crate::comparison) use resampler::Resampler;
