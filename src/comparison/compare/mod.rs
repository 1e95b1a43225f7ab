//! Two motions sample by sample: tolerances, pairing by time, measures of what is between them.

mod comparison;
mod error;
mod facts;
mod matching;
mod measure;
mod pairing;
mod report;
mod side;
mod tolerance;
mod work;

pub use comparison::Comparison;
pub use error::CompareError;
pub use measure::{Bits, Growth, Law, Mark, Trace, Worst};
pub use report::{
    BodyReport, ChannelReport, Coverage, Difference, EventDifference, FactDifference, Finding, Report, Shapes,
    SideReport,
};
pub use side::Side;
pub use tolerance::{Rule, Tolerance, ToleranceError, Tolerances, channel_named};
