//! Threads for what is done side by side, started before it is begun: a system that has no room for them says so then.

use thiserror::Error;

/// There is no room for threads.
#[derive(Debug, Error)]
#[error("cannot start threads to work side by side: {0}")]
pub struct NoThreads(#[from] rayon::ThreadPoolBuildError);

/// One for each processor; once in the life of the program.
pub fn start() -> Result<(), NoThreads> {
    Ok(rayon::ThreadPoolBuilder::new().build_global()?)
}
