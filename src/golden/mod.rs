//! One line in another crate's test: is its simulation the motion of a golden recording, or the exact one?
//!
//! ```no_run
//! use polhode::golden::{self, Limits, Pose};
//! # struct Engine;
//! # impl Engine {
//! #     fn advance_to(&mut self, _: f64) {}
//! #     fn quaternion_wxyz(&self) -> [f64; 4] { [1.0, 0.0, 0.0, 0.0] }
//! # }
//! # fn main() -> Result<(), polhode::golden::HoldError> {
//! # let mut engine = Engine;
//! let report = golden::hold("tests/golden/tumbling.mcap", Limits::attitude(1e-6), |time_s| {
//!     engine.advance_to(time_s);
//!     Pose::wxyz(engine.quaternion_wxyz())
//! })?;
//! println!("{report}"); // how far it stayed within the limit
//! # Ok(())
//! # }
//! ```
//!
//! The closure is asked for each of the golden's times once, ascending, so that it can advance a stepper. What leaves its
//! limit is an error whose text is the report: the first divergence, the worst, how the difference grows, and a table of
//! the times about it.
//!
//! A [`Golden`] is a recording of this crate (`.csv`; `.mcap` and `.rrd` with the features of these names), a plan, a scene
//! (feature `serde`), or the torque-free motion in closed form:
//!
//! ```
//! use polhode::golden::{Golden, Limits, Pose};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // About a principal axis: the answer is known without a program.
//! let start = Pose::wxyz([1.0, 0.0, 0.0, 0.0]).turning_in_body([0.0, 0.0, 3.0]);
//! let golden = Golden::free([1.0, 2.0, 3.0], start, 10.0, 0.1)?;
//! let report = golden.hold(Limits::attitude(1e-14).angular_velocity(1e-15), |time_s| {
//!     let half: f64 = 3.0 * time_s / 2.0;
//!     Pose::wxyz([half.cos(), 0.0, 0.0, half.sin()]).turning_in_world([0.0, 0.0, 3.0])
//! })?;
//! assert!(report.attitude.is_some_and(|worst| worst.difference < 1e-14));
//!
//! // The quaternion's parts in another order are another motion, and the report says since when.
//! let error = golden.hold(Limits::attitude(1e-3), |time_s| {
//!     let half: f64 = 3.0 * time_s / 2.0;
//!     Pose::wxyz([half.sin(), 0.0, 0.0, half.cos()])
//! });
//! assert!(error.is_err_and(|error| error.to_string().contains("first out of its limit at 0 s")));
//! # Ok(())
//! # }
//! ```
//!
//! Units are SI; quaternions turn body components into world components, q and −q alike. How to make goldens of scenes of
//! one's own, and what to put into a continuous integration: `docs/golden.md`.

mod error;
mod hold;
mod limits;
mod pose;
mod report;
mod sources;

pub use error::{GoldenError, HoldError};
pub use hold::hold;
pub use limits::Limits;
pub use pose::Pose;
pub use report::{Divergence, Quantity, Report, Row, Worst};
pub use sources::Golden;
