use std::fmt;
use std::path::PathBuf;

use thiserror::Error;

use super::Report;
use crate::propagation::PropagationError;
use crate::recording::RecordingError;
use crate::scenario::ScenarioError;

/// A golden that cannot be had.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum GoldenError {
    /// The recording cannot be read.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// The scene cannot be read or planned.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// The exact motion cannot be computed.
    #[error(transparent)]
    Propagation(#[from] PropagationError),
    /// A recording that is cut off.
    #[error("{path} is unfinished: `polhode recover` makes a whole recording of it", path = path.display())]
    Unfinished {
        /// Which file.
        path: PathBuf,
    },
    /// Several bodies and no word which, or one that is not there.
    #[error("{golden} holds the bodies {names}: name one of them", names = names.join(", "))]
    WhichBody {
        /// Which golden.
        golden: String,
        /// The bodies that there are.
        names: Vec<String>,
    },
    /// A recording that does not tell the attitude.
    #[error("{golden} has no channel \"attitude\" of {body}")]
    NoAttitude {
        /// Which golden.
        golden: String,
        /// Of which body.
        body: String,
    },
    /// A start without an angular velocity.
    #[error("the start does not say how the body turns: Pose::turning_in_body or turning_in_world")]
    NoAngularVelocity,
    /// A limit for what the golden does not tell.
    #[error("{golden} does not tell the angular velocity, for which a limit is given")]
    NothingToLimit {
        /// Which golden.
        golden: String,
    },
    /// Nothing to compare with: no sample, or none before [`Limits::until`](super::Limits::until).
    #[error("{golden} has no sample to compare with")]
    Empty {
        /// Which golden.
        golden: String,
    },
}

/// A simulation that is not the golden's motion, or a golden that cannot be had.
///
/// Printed for people by `{}` and by `{:?}` alike: the latter is what a test shows that returns it.
#[non_exhaustive]
pub enum HoldError {
    /// There is nothing to hold it to.
    Golden(GoldenError),
    /// It leaves a limit.
    Diverged(Box<Report>),
}

impl fmt::Display for HoldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Golden(error) => error.fmt(f),
            Self::Diverged(report) => report.fmt(f),
        }
    }
}

impl fmt::Debug for HoldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for HoldError {}

impl<E: Into<GoldenError>> From<E> for HoldError {
    fn from(error: E) -> Self {
        Self::Golden(error.into())
    }
}
