//! The built program where the machine gets in its way: signals, streams that are closed or full, names that are no text,
//! limits of the process, odd surroundings.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;

use crate::contested_names::folder;

mod interrupts;
mod limits;
mod paths;
mod streams;
mod surroundings;

const FORMATS: [&str; 3] = ["mcap", "rrd", "csv"];

/// Every command that says something on stdout, as it is asked in [`prepared`] folders; each takes well under a second.
const TALKERS: [&[&str]; 17] = [
    &["--help"],
    &["--version"],
    &["help", "run"],
    &["run", "--help"],
    &["list"],
    &["list", "--json"],
    &["plan", "scene.toml"],
    &["run", "scene.toml", "--force"],
    &["run", "scene.toml", "--force", "--json"],
    &["inspect", "scene.mcap"],
    &["verify", "scene.mcap"],
    &["compare", "scene.mcap", "scene.csv", "--json"],
    &["digest", "scene.rrd"],
    &["convert", "scene.mcap", "again.csv", "--force"],
    &["bench", "scene.toml", "--methods", "closed_form", "--errors", "1e-3", "--budget", "0"],
    &["stress", "--cases", "sphere", "--methods", "closed_form"],
    &["golden", "scene.toml", "--folder", "goldens", "--bless"],
];

/// Every command that writes a file, and a word of its name.
const WRITERS: [(&[&str], &str); 11] = [
    (&["run", "scene.toml", "--out", "new"], "new/scene."),
    (&["convert", "scene.mcap", "new.rrd"], "new.rrd"),
    (&["recover", "cut.mcap.part"], "cut."),
    (&["plot", "scene.mcap", "-o", "new.svg"], "new.svg"),
    (&["report", "scene.mcap", "-o", "new.html"], "new.html"),
    (&["compare", "scene.mcap", "scene.csv", "--record", "new.rrd"], "new.rrd"),
    (&["compare", "scene.mcap", "scene.csv", "--plot", "new.png"], "new.png"),
    (
        &["bench", "scene.toml", "--methods", "closed_form", "--errors", "1e-3", "--budget", "0", "--csv", "new.csv"],
        "new.csv",
    ),
    (
        &["bench", "scene.toml", "--methods", "closed_form", "--errors", "1e-3", "--budget", "0", "--plot", "new.svg"],
        "new.svg",
    ),
    (&["stress", "--cases", "sphere", "--methods", "closed_form", "--plot", "new.svg"], "new.svg"),
    (&["golden", "scene.toml", "--folder", "goldens", "--bless"], "scene."),
];

/// A folder with a scene, its recordings in every format, and what a killed run left.
fn prepared() -> TempDir {
    let folder = folder();
    let made = asked(folder.path(), &["run", "scene.toml", "--quiet", "--out", ".", "--format", "mcap,rrd,csv"]);
    assert_eq!(made.status.code(), Some(0), "{made:?}");
    let whole = fs::read(folder.path().join("scene.mcap")).expect("recorded");
    fs::write(folder.path().join("cut.mcap.part"), &whole[..whole.len() - 20]).expect("room");
    folder
}

fn program(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
    command.current_dir(folder);
    command
}

fn asked(folder: &Path, arguments: &[&str]) -> Output {
    program(folder).args(arguments).output().expect("the program starts")
}

/// Asked by a shell that does `first` before it becomes the program.
fn shell(folder: &Path, first: &str, arguments: &[&str]) -> Output {
    let mut command = Command::new("sh");
    command.current_dir(folder).args(["-c", &format!("{first} exec \"$0\" \"$@\"")]);
    command.arg(env!("CARGO_BIN_EXE_polhode")).args(arguments).output().expect("a shell")
}

/// What it said on stderr, for people and for assertions.
fn said(output: &Output) -> String {
    let said = String::from_utf8(output.stderr.clone()).expect("messages are UTF-8");
    assert!(!said.contains("panicked"), "{said}");
    said
}

/// Everything in a folder, parts aside, and what is in its folders.
fn finals(folder: &Path) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            names.extend(finals(&path));
        } else if path.extension().is_none_or(|extension| extension != "part") {
            names.insert(path.to_string_lossy().into_owned());
        }
    }
    names
}
