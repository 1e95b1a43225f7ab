use std::path::PathBuf;

use thiserror::Error;

use crate::propagation::PropagationError;

/// A recording that cannot be written or read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RecordingError {
    /// The operating system refused.
    #[error("cannot {attempt} {path}: {source}", path = path.display())]
    Io {
        /// What was attempted, as a verb: `create`, `write`, `sync`, `rename`, `read`.
        attempt: &'static str,
        /// On which file.
        path: PathBuf,
        /// Why not.
        source: std::io::Error,
    },
    /// The file is there already.
    #[error("{path} exists already: --force overwrites it", path = path.display())]
    Exists {
        /// Which file.
        path: PathBuf,
    },
    /// A library for the format refused to encode.
    #[error("cannot encode {path}: {reason}", path = path.display())]
    Encode {
        /// Which file.
        path: PathBuf,
        /// What the library said.
        reason: String,
    },
    /// A file that is not what its name says, or is damaged.
    #[error("cannot read {path}: {reason}", path = path.display())]
    Decode {
        /// Which file.
        path: PathBuf,
        /// What is wrong with it, and where.
        reason: String,
    },
    /// What a file does not say of itself, and the mapping does not either, or not so that it fits.
    #[error("{path} and its mapping: {reason}", path = path.display())]
    Mapping {
        /// Which file.
        path: PathBuf,
        /// The key, the value met and the rule.
        reason: String,
    },
    /// An extension that stands for no format.
    #[error("{path}: a recording ends in .mcap, .rrd or .csv", path = path.display())]
    UnknownFormat {
        /// Which file.
        path: PathBuf,
    },
    /// A format that this build leaves out.
    #[error("{path}: this build has no {feature} (cargo feature `{feature}`)", path = path.display())]
    FormatAbsent {
        /// Which file.
        path: PathBuf,
        /// The feature that brings it.
        feature: &'static str,
    },
    /// A viewer that is not there, or not any more.
    #[error("cannot show the run in the viewer at {address}: {source}; `rerun` opens one")]
    NoViewer {
        /// Where it was expected.
        address: String,
        /// Why not.
        source: std::io::Error,
    },
    /// The motion cannot be looked over to choose scales and camera.
    #[error("cannot look the motion over: {0}")]
    Preview(#[from] PropagationError),
    /// A part file in which there is nothing to recover.
    #[error("{path} holds no whole sample: there is nothing to recover", path = path.display())]
    NothingKept {
        /// Which file.
        path: PathBuf,
    },
    /// A scene that is not the one of the recording.
    #[error("{path} is no recording of that scene: {reason}", path = path.display())]
    OtherScene {
        /// Which recording.
        path: PathBuf,
        /// In what they differ.
        reason: String,
    },
    /// Something the format cannot hold.
    #[error("{path}: {rule}", path = path.display())]
    NotRepresentable {
        /// Which file.
        path: PathBuf,
        /// The value met and the rule.
        rule: String,
    },
}
