use thiserror::Error;

use crate::propagation::PropagationError;
use crate::recording::RecordingError;
use crate::scenario::ScenarioError;

/// Two motions that cannot be compared.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CompareError {
    /// A side cannot be read.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// A side cannot be run.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// A scene cannot be propagated to the times of the other side.
    #[error(transparent)]
    Propagation(#[from] PropagationError),
    /// A side without a sample in the time that is to be compared.
    #[error("{side} has no sample{window}")]
    Empty {
        /// Which.
        side: String,
        /// ` from … to … s`, if a window was asked for.
        window: String,
    },
    /// Times that do not meet.
    #[error(
        "the sides have {common} of their times in common: {a} has {} times from {} to {} s, {b} has {} from {} to {} s; \
         to compare them all the same, resample the second at the times of the first (--resample)",
        .times[0].samples, .times[0].from_s, .times[0].to_s, .times[1].samples, .times[1].from_s, .times[1].to_s
    )]
    NoCommonTimes {
        /// The first side.
        a: String,
        /// The second side.
        b: String,
        /// How many times they share.
        common: u64,
        /// When they have samples.
        times: [super::Coverage; 2],
    },
    /// A name that none of a side's bodies has.
    #[error("{side} has no body {name:?}{hint}")]
    UnknownBody {
        /// Which side.
        side: String,
        /// As asked for.
        name: String,
        /// `: did you mean …?`, or which there are.
        hint: String,
    },
    /// Two sides that have nothing that could be compared.
    #[error("{a} and {b} have no body of one name with a channel in common: --body A=B says which is which")]
    NothingInCommon {
        /// The first side.
        a: String,
        /// The second side.
        b: String,
    },
}
