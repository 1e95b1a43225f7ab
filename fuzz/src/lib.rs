//! The targets of the tests, and a place in memory for their files.

use std::path::Path;
use std::sync::LazyLock;

use tempfile::TempDir;

#[path = "../../tests/suite/corpora/targets.rs"]
pub mod targets;

static FOLDER: LazyLock<TempDir> = LazyLock::new(|| {
    let in_memory = Path::new("/dev/shm");
    let folder = if in_memory.is_dir() { in_memory.to_owned() } else { std::env::temp_dir() };
    let folder = TempDir::new_in(folder).expect("a folder for inputs");
    // libFuzzer aborts at every panic; the reader of .rrd catches those of Arrow's, and what is not caught ends it anyway.
    #[cfg(feature = "rerun")]
    std::panic::set_hook(Box::new(|_| {}));
    folder
});
static SCRATCH: LazyLock<targets::Scratch> = LazyLock::new(|| targets::Scratch::new(FOLDER.path()));

/// Where targets put their files; made at the first input.
pub fn scratch() -> &'static targets::Scratch {
    &SCRATCH
}
