//! The built program where it cannot write: full disks, folders that are none, names that are taken, two runs at once.
//! Exit code 2, a message that names the file, and nothing under a final name that is not whole.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

use polhode::recording::contents;
use tempfile::{TempDir, tempdir};

pub const SCENE: &str = "
title = \"A tumbling body\"
duration_s = 1.0
sample_every_s = 1e-3

[[body]]
principal_moments_kg_m2 = [1.0, 2.0, 2.5]
angular_velocity_rad_s = [0.1, 3.0, 0.2]
";
const RECORDINGS: [&str; 3] = ["scene.csv", "scene.mcap", "scene.rrd"];

pub fn folder() -> TempDir {
    let folder = tempdir().expect("a folder");
    fs::write(folder.path().join("scene.toml"), SCENE).expect("room");
    folder
}

fn command(folder: &Path, flags: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
    command.current_dir(folder).args(["run", "--quiet", "--format", "mcap,rrd,csv"]).args(flags);
    if !flags.contains(&"--out") {
        command.args(["--out", "out"]);
    }
    command
}

fn run(folder: &Path, flags: &[&str]) -> Output {
    command(folder, flags).output().expect("the program starts")
}

fn start(folder: &Path, flags: &[&str]) -> Child {
    command(folder, flags).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// What the folder of recordings holds.
fn names(folder: &Path) -> BTreeSet<String> {
    let Ok(entries) = fs::read_dir(folder.join("out")) else { return BTreeSet::new() };
    entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("a name")).collect()
}

/// Fails unless the run was impossible and `words` say why.
fn assert_impossible(output: &Output, words: &[&str]) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    for word in words {
        assert!(said.contains(word), "{word:?} in {said}");
    }
    assert!(!said.contains("panicked"), "{said}");
}

fn assert_whole(folder: &Path, names: &[&str]) {
    for name in names {
        let read = contents(&folder.join("out").join(name)).expect("under its final name a file is whole");
        assert_eq!(read.survey.expect("columns").samples, 1001, "{name}");
    }
}

#[cfg(target_os = "linux")]
fn assert_only_parts(folder: &Path) {
    let names = names(folder);
    assert!(names.iter().all(|name| Path::new(name).extension() == Some("part".as_ref())), "{names:?}");
}

/// A file may have as many blocks of 512 bytes as this, as on a disk that is full then; `signal` is what the shell does about the
/// signal that comes with it.
#[cfg(target_os = "linux")]
fn with_room_for(folder: &Path, blocks: u64, signal: &str) -> Output {
    Command::new("sh")
        .current_dir(folder)
        .args(["-c", &format!("{signal} ulimit -c 0; ulimit -f {blocks}; exec \"$0\" \"$@\"")])
        .arg(env!("CARGO_BIN_EXE_polhode"))
        .args(["run", "--quiet", "--out", "out", "--format", "mcap,rrd,csv", "scene.toml"])
        .output()
        .expect("a shell")
}

#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_fills_up_ends_the_run_and_no_format_gets_its_name() {
    let folder = folder();
    assert_eq!(run(folder.path(), &["scene.toml"]).status.code(), Some(0));
    let largest = RECORDINGS.map(|name| fs::metadata(folder.path().join("out").join(name)).expect("recorded").len());
    let blocks = largest.into_iter().max().expect("three") / 512 - 1;
    // From nothing to a little less than the largest needs: then the others have long been complete.
    for room in (0..=8).map(|part| part * blocks / 8) {
        fs::remove_dir_all(folder.path().join("out")).expect("a folder");
        let output = with_room_for(folder.path(), room, "trap '' XFSZ;");
        assert_impossible(&output, &["cannot write out/scene.", "File too large"]);
        assert_only_parts(folder.path());
    }
    // A shell that does not ignore the signal lets it kill the run.
    fs::remove_dir_all(folder.path().join("out")).expect("a folder");
    assert_eq!(with_room_for(folder.path(), blocks / 2, "").status.code(), None);
    assert_only_parts(folder.path());
}

#[test]
fn a_folder_that_is_missing_is_made_and_one_that_cannot_be_is_named() {
    let folder = folder();
    let deep = ["scene.toml", "--out", "some/folder/deep below"];
    assert_eq!(run(folder.path(), &deep).status.code(), Some(0));
    assert!(folder.path().join("some/folder/deep below/scene.mcap").is_file());
    let below_a_file = run(folder.path(), &["scene.toml", "--out", "scene.toml/out"]);
    assert_impossible(&below_a_file, &["cannot make the folder scene.toml/out"]);
    let a_file = run(folder.path(), &["scene.toml", "--out", "scene.toml"]);
    assert_impossible(&a_file, &["cannot make the folder scene.toml"]);
    assert_eq!(fs::read_to_string(folder.path().join("scene.toml")).expect("untouched"), SCENE);
}

/// A folder in which nobody may create a file, whoever runs this.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_nobody_may_write_to_is_named() {
    let folder = folder();
    for out in ["/proc", "/proc/self/fd"] {
        let output = run(folder.path(), &["scene.toml", "--out", out]);
        assert_impossible(&output, &[&format!("cannot create {out}/scene.")]);
    }
}

#[test]
fn a_folder_under_the_name_of_a_recording_is_refused_before_the_run() {
    for name in RECORDINGS.into_iter().chain(["scene.layout.json"]) {
        for flags in [&["scene.toml"][..], &["scene.toml", "--force"]] {
            let folder = folder();
            fs::create_dir_all(folder.path().join("out").join(name)).expect("a folder");
            assert_impossible(&run(folder.path(), flags), &[&format!("out/{name}"), "is a directory"]);
            assert_eq!(names(folder.path()), BTreeSet::from([name.to_owned()]), "nothing else was left");
        }
    }
}

#[test]
fn what_is_there_is_kept_until_forced() {
    for name in RECORDINGS.into_iter().chain(["scene.layout.json", "scene.rrd.part"]) {
        let folder = folder();
        fs::create_dir(folder.path().join("out")).expect("a folder");
        let path = folder.path().join("out").join(name);
        fs::write(&path, "precious").expect("room");
        assert_impossible(&run(folder.path(), &["scene.toml"]), &[&format!("out/{name} exists already: --force")]);
        assert_eq!(fs::read_to_string(&path).expect("untouched"), "precious");
        assert_eq!(names(folder.path()), BTreeSet::from([name.to_owned()]), "nothing else was left");
        assert_eq!(run(folder.path(), &["scene.toml", "--force"]).status.code(), Some(0));
        assert_whole(folder.path(), &RECORDINGS);
    }
}

#[test]
fn a_run_into_the_name_of_one_that_goes_on_is_refused_even_by_force() {
    let folder = folder();
    let mut first = start(folder.path(), &["scene.toml", "--duration", "1e4"]);
    let part = folder.path().join("out/scene.csv.part");
    while fs::metadata(&part).map_or(0, |file| file.len()) == 0 {
        assert!(first.try_wait().expect("it is ours").is_none(), "ten million samples are not done yet");
        std::thread::yield_now();
    }
    for flags in [&["scene.toml"][..], &["scene.toml", "--force"]] {
        assert_impossible(&run(folder.path(), flags), &["another run is writing it"]);
    }
    assert_eq!(run(folder.path(), &["scene.toml", "--out", "elsewhere"]).status.code(), Some(0));
    assert!(first.try_wait().expect("it is ours").is_none(), "the first goes on");
    first.kill().expect("it is ours");
    first.wait().expect("it ends");
    assert_eq!(run(folder.path(), &["scene.toml", "--force"]).status.code(), Some(0), "the lock ended with the run");
    assert_whole(folder.path(), &RECORDINGS);
}

#[test]
fn of_two_runs_at_once_one_wins_and_the_other_says_so() {
    for round in 0..10 {
        let folder = folder();
        let racers = [(); 2].map(|()| start(folder.path(), &["scene.toml"]));
        let outputs = racers.map(|racer| racer.wait_with_output().expect("it ends"));
        let mut codes = outputs.each_ref().map(|output| output.status.code());
        codes.sort_unstable();
        assert_eq!(codes, [Some(0), Some(2)], "round {round}: {outputs:?}");
        let loser = outputs.iter().find(|output| output.status.code() == Some(2)).expect("one lost");
        assert_impossible(loser, &["scene."]);
        assert_whole(folder.path(), &RECORDINGS);
    }
    for round in 0..10 {
        let folder = folder();
        let racers = [(); 2].map(|()| start(folder.path(), &["scene.toml", "--force"]));
        let outputs = racers.map(|racer| racer.wait_with_output().expect("it ends"));
        let codes = outputs.each_ref().map(|output| output.status.code());
        // Where one is done before the other begins, both are.
        assert!(codes.contains(&Some(0)), "round {round}: {outputs:?}");
        assert!(codes.iter().all(|code| matches!(code, Some(0 | 2))), "round {round}: {outputs:?}");
        assert_whole(folder.path(), &RECORDINGS);
        assert_eq!(names(folder.path()).len(), 4, "round {round}: three recordings and a layout, no part");
    }
}

#[test]
fn two_scenes_at_once_share_a_folder() {
    for _ in 0..5 {
        let folder = folder();
        fs::write(folder.path().join("other.toml"), SCENE).expect("room");
        let racers = ["scene.toml", "other.toml"].map(|scene| start(folder.path(), &[scene]));
        for racer in racers {
            let output = racer.wait_with_output().expect("it ends");
            assert_eq!(output.status.code(), Some(0), "{output:?}");
        }
        assert_whole(folder.path(), &RECORDINGS);
        assert_whole(folder.path(), &["other.csv", "other.mcap", "other.rrd"]);
    }
}
