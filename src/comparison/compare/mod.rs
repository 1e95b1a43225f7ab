//! Two motions sample by sample: tolerances, pairing by time, measures of what is between them.

mod bits;
mod comparison;
mod cursor;
mod distance;
mod error;
mod follower;
mod growth;
mod matching;
mod measure;
mod pairs;
mod report;
mod side;
mod tolerance;
mod trace;
mod verdict;

pub use bits::{Bits, Mark};
pub use comparison::Comparison;
pub use error::CompareError;
pub use growth::{Growth, Law};
pub use measure::Worst;
pub use report::{BodyReport, ChannelReport, Coverage, Difference, FactDifference, Report, SideReport};
pub use side::Side;
pub use tolerance::{Rule, Tolerance, ToleranceError, Tolerances};
pub use trace::Trace;
