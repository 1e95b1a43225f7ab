//! Two motions sample by sample: tolerances, pairing by time, measures of what is between them.

mod bits;
mod comparison;
mod cursor;
mod distance;
mod error;
mod follower;
mod growth;
mod interpolation;
mod matching;
mod measure;
mod pairs;
mod report;
mod resampler;
mod side;
mod tolerance;
mod tolerance_error;
#[cfg(feature = "serde")]
mod tolerance_file;
mod tolerance_words;
mod trace;
mod verdict;

pub use bits::{Bits, Mark};
pub use comparison::Comparison;
pub use error::CompareError;
pub use growth::{Growth, Law};
pub use measure::Worst;
pub use report::{BodyReport, ChannelReport, Coverage, Difference, FactDifference, Finding, Report, SideReport};
pub use side::Side;
pub use tolerance::{Rule, Tolerance, Tolerances};
pub use tolerance_error::ToleranceError;
pub use tolerance_words::channel_named;
pub use trace::Trace;
