use std::path::{Path, PathBuf};
use std::{fs, io};

use thiserror::Error;

/// A folder of this process' own among the system's temporary files, which goes with this value.
#[derive(Debug)]
pub struct TemporaryFolder(PathBuf);

/// A folder that cannot be made.
#[derive(Debug, Error)]
#[error("cannot make the folder {path}: {source}", path = path.display())]
pub struct FolderError {
    /// Which.
    pub path: PathBuf,
    /// Why not.
    pub source: io::Error,
}

impl TemporaryFolder {
    /// For the command called `word`.
    pub fn create(word: &str) -> Result<Self, FolderError> {
        let path = std::env::temp_dir().join(format!("polhode-{word}-{}", std::process::id()));
        fs::create_dir(&path).map_err(|source| FolderError { path: path.clone(), source })?;
        Ok(Self(path))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        // What cannot be removed is left to the system, whose folder it is in.
        let _ = fs::remove_dir_all(&self.0);
    }
}
