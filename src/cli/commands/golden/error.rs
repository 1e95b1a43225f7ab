use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::cli::folder::FolderError;
use crate::cli::interrupt::Signal;
use crate::comparison::CompareError;
use crate::propagation::PropagationError;
use crate::recording::RecordingError;
use crate::scenario::ScenarioError;

/// Why goldens cannot be looked at or written.
#[derive(Debug, Error)]
pub enum GoldenError {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error(transparent)]
    Compare(#[from] CompareError),
    #[error("cannot measure the checks: {0}")]
    Checks(#[from] PropagationError),
    #[error(transparent)]
    Folder(#[from] FolderError),
    #[error("cannot {attempt} {path}: {source}", path = path.display())]
    Io { attempt: &'static str, path: PathBuf, source: io::Error },
    #[error("{0}: interrupted: no golden is changed")]
    Interrupted(Signal),
    #[error("there are no goldens in {path}: `--bless` writes them", path = path.display())]
    NoFolder { path: PathBuf },
    #[error("there is no scene in {path}: scenes are TOML files", path = path.display())]
    NoScenes { path: PathBuf },
    #[error("{path:?}: the name of a scene must be UTF-8")]
    NoText { path: PathBuf },
    #[error("two scenes are called {0:?}: their goldens would have one name")]
    SameName(String),
}
