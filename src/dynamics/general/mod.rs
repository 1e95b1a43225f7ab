//! Loads that are written down once, as operations on a tape, and have no recurrence laid out by hand.
//!
//! The same operations give a moment at an instant, its Taylor series, and that series in double-double. The listed loads
//! can be laid out so too ([`Torque::lay_out`](crate::dynamics::Torque::lay_out)): all that acts on a body is then one tape.

mod axes;
mod control;
mod drag;
mod formula;
mod kind;
mod listed;
mod load;
mod sphere;
mod spring;
mod symbols;

pub use control::{BDot, QuaternionFeedback, RateFeedback};
pub use formula::{FormulaLoad, FormulaPlace};
pub use kind::General;
pub use load::GeneralLoad;
pub use sphere::InnerSphere;
pub use spring::Spring;
pub use symbols::{Push, Symbols};
