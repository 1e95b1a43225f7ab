use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};

use thiserror::Error;

use super::convert::{has_extension, say_why_there_is_no_picture};
use crate::cli::args::ViewArguments;
use crate::cli::execute::{Outcome, scenario};
use crate::cli::folder::{FolderError, TemporaryFolder};
use crate::cli::output::remark;
use crate::propagation::PropagationError;
use crate::recording::{Conversion, Recorder, RecordingError};
use crate::scenario::{Plan, ScenarioError};

/// The version whose files this program writes.
const VERSION: &str = "0.36.3";

/// Why nothing is to be seen.
#[derive(Debug, Error)]
enum ViewError {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error("cannot measure the checks: {0}")]
    Checks(#[from] PropagationError),
    #[error(
        "there is no Rerun viewer (`rerun`) on PATH: `pip install rerun-sdk=={VERSION}` brings it, or \
         `cargo install rerun-cli@{VERSION} --locked`"
    )]
    NoViewer,
    #[error(transparent)]
    Folder(#[from] FolderError),
    #[error("cannot start {path}: {source}", path = path.display())]
    Start { path: PathBuf, source: io::Error },
    #[error("{path} ended with {status}", path = path.display())]
    Viewer { path: PathBuf, status: ExitStatus },
    #[error("{path} is unfinished: `polhode recover` makes a whole recording of it", path = path.display())]
    Part { path: PathBuf },
}

/// Opens the Rerun viewer on a recording or a scene, and waits until it is closed.
pub fn execute(arguments: &ViewArguments) -> Outcome {
    match view(&arguments.what) {
        Ok(()) => Outcome::Done,
        Err(error) => {
            remark(&format!("error: {error}"));
            Outcome::Impossible
        }
    }
}

fn view(what: &str) -> Result<(), ViewError> {
    let viewer = viewer().ok_or(ViewError::NoViewer)?;
    let path = Path::new(what);
    if has_extension(path, "part") {
        return Err(ViewError::Part { path: path.into() });
    }
    if has_extension(path, "rrd") {
        // The viewer would open its window on a file that is not there, too.
        let absent = |source| RecordingError::Io { attempt: "read", path: path.into(), source };
        fs::metadata(path).map_err(absent)?;
        return show(&viewer, path);
    }
    let folder = TemporaryFolder::create("view")?;
    let recording = if has_extension(path, "mcap") || has_extension(path, "csv") {
        converted(path, folder.path())?
    } else {
        recorded(what, folder.path())?
    };
    show(&viewer, &recording)
}

/// The viewer, where the shell would find it.
fn viewer() -> Option<PathBuf> {
    let name = format!("rerun{}", std::env::consts::EXE_SUFFIX);
    let folders = std::env::var_os("PATH")?;
    std::env::split_paths(&folders).map(|folder| folder.join(&name)).find(|path| is_program(path))
}

#[cfg(unix)]
fn is_program(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    fs::metadata(path).is_ok_and(|file| file.is_file() && file.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_program(path: &Path) -> bool {
    path.is_file()
}

fn show(viewer: &Path, recording: &Path) -> Result<(), ViewError> {
    let path = || viewer.to_path_buf();
    let status = Command::new(viewer).arg(recording).status();
    let status = status.map_err(|source| ViewError::Start { path: path(), source })?;
    if status.success() { Ok(()) } else { Err(ViewError::Viewer { path: path(), status }) }
}

/// Another format as an `.rrd`.
fn converted(path: &Path, folder: &Path) -> Result<PathBuf, ViewError> {
    let conversion = Conversion::of(path)?;
    say_why_there_is_no_picture(path, &conversion);
    let target = folder.join(path.with_extension("rrd").file_name().unwrap_or_default());
    conversion.write(&[&target], false)?;
    Ok(target)
}

/// A run of a scene as an `.rrd`.
fn recorded(name: &str, folder: &Path) -> Result<PathBuf, ViewError> {
    let plan = Plan::new(&scenario(name, &[])?)?.checked()?;
    let target = folder.join(format!("{}.rrd", plan.name));
    let mut recorder = Recorder::create(&plan, &[&target], false)?;
    let mut run = plan.start()?;
    while let Some(samples) = run.next_batch()? {
        recorder.write(samples)?;
    }
    recorder.finish()?;
    Ok(target)
}
