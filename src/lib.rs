//! Exact motions of rotating rigid bodies, recorded for Rerun and Foxglove.
//!
//! Modules in floor order, each using only those above it in this list:
//! [`numerics`], [`body`], [`dynamics`], [`propagation`], [`telemetry`], [`scenario`], [`recording`].

pub mod numerics;

pub mod body;

pub mod dynamics;

pub mod propagation;

pub mod telemetry;

pub mod scenario;

pub mod recording;

#[cfg(feature = "cli")]
pub mod cli;
