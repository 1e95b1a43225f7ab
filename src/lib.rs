//! Exact motions of rotating rigid bodies, recorded for Rerun and Foxglove.
//!
//! *The polhode is the curve that the angular velocity draws on a tumbling body.* A scene says what turns, how it starts
//! and what acts on it; a [`scenario::Plan`] checks it and chooses for each body the path that is exact where one is known;
//! a [`scenario::Run`] lends the motion batch by batch, as columns; a [`recording::Recorder`] keeps it.
//!
//! # A run in memory
//!
//! ```
//! use polhode::scenario::{BodySpec, Plan, Scenario};
//! use polhode::telemetry::Channel;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // A book, thrown so that it turns about its middle axis: it will flip.
//! let book = BodySpec {
//!     principal_moments_kg_m2: Some([0.0020, 0.0042, 0.0060]),
//!     angular_velocity_rad_s: Some([0.05, 10.0, 0.05]),
//!     ..BodySpec::default()
//! };
//! let scene =
//!     Scenario { duration_s: Some(2.0), sample_every_s: Some(0.01), body: vec![book], ..Scenario::default() };
//! let plan = Plan::new(&scene)?;
//! let mut run = plan.start()?;
//! while let Some(samples) = run.next_batch()? {
//!     let omega = samples.bodies[0].channel(Channel::AngularVelocity).ok_or("not recorded")?;
//!     let flipped = omega[1].iter().position(|rate| *rate < 0.0).ok_or("no flip")?;
//!     println!("flipped at {:.2} s", samples.times_s[flipped]); // flipped at 1.26 s
//! #   assert_eq!(samples.times_s[flipped], 1.26);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! One state at one time, without a scene: [`propagation::FreeRotation`] and [`propagation::Taylor`] take a
//! [`dynamics::Problem`] and fill columns of [`propagation::States`].
//!
//! # Modules, from the ground up
//!
//! Each uses only those before it.
//!
//! * [`numerics`]: elliptic functions, theta series, rotation maps, double-double.
//! * [`body`]: mass properties from moments, tensor, particles, solids, mesh; attitude, rates, state.
//! * [`dynamics`]: torques, forces, Euler's equations, the laws that motions obey.
//! * [`propagation`]: states at given times, by closed form or by steps.
//! * [`telemetry`]: named channels with unit and frame, as columns.
//! * [`scenario`]: what was asked, what will be done, what is happening, and what it must show.
//! * [`recording`]: columns to `.mcap`, `.rrd` and `.csv`, whole or not at all.
//! * [`comparison`]: are two recordings the same motion? is one of them true?
//! * `golden` (feature): is another program's simulation the motion of a recording, or the exact one?
//! * `plot` (feature): plots and pages, without a viewer.
//! * [`study`]: how good a run is, and what each method costs for how much accuracy.
//!
//! # Features
//!
//! `serde` reads scenes and meshes from files, `mcap` and `rerun` write those formats, `parallel` runs scenes side by side,
//! `plot` draws, `golden` lets another crate's tests hold its simulation against a recording, `cli` (default) is the program and takes them all.
//!
//! # Conventions
//!
//! SI units; quaternions w, x, y, z, from body to world; ω in body axes, L in world axes unless a name says otherwise.

pub mod numerics;

pub mod body;

pub mod dynamics;

pub mod propagation;

pub mod telemetry;

pub mod scenario;

pub mod recording;

pub mod comparison;

#[cfg(feature = "golden")]
pub mod golden;

#[cfg(feature = "plot")]
pub mod plot;

pub mod study;

#[cfg(feature = "cli")]
pub mod cli;

/// The README's examples, tested.
#[cfg(all(doctest, feature = "cli"))]
#[doc = include_str!("../README.md")]
struct Readme;
