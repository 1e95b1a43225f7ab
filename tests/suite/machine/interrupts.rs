//! SIGINT, SIGTERM, SIGHUP: what is being recorded is ended so that it can be read, and nothing more is begun.

use std::fs;
use std::io::Read as _;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use polhode::recording::{Conversion, Recording, contents};
use serde_json::Value;

use super::{FORMATS, finals, prepared, program, said};
use crate::contested_names::{SCENE, folder};

/// Four million samples: much more than is recorded before the signal comes.
const ENDLESS: [&str; 4] = ["--duration", "4e3", "--format", "mcap,rrd,csv"];

fn start(folder: &Path, arguments: &[&str]) -> Child {
    let child = program(folder).args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    child.expect("the program starts")
}

fn send(signal: &str, to: &Child) {
    // The shell's own: nothing else need be installed. What has ended meanwhile takes no signal.
    let kill = format!("kill -{signal} {}", to.id());
    Command::new("sh").args(["-c", &kill]).stderr(Stdio::null()).status().expect("a shell");
}

fn wait_until(child: &mut Child, what: impl Fn() -> bool) {
    while !what() {
        assert!(child.try_wait().expect("it is ours").is_none(), "it ended before the signal");
        std::thread::yield_now();
    }
}

/// One signal after the other, until it ends.
fn insist(signal: &str, child: &mut Child) -> Option<i32> {
    loop {
        if let Some(status) = child.try_wait().expect("it is ours") {
            return status.code();
        }
        send(signal, child);
    }
}

fn size(path: &Path) -> u64 {
    fs::metadata(path).map_or(0, |file| file.len())
}

/// A process' signals of a kind: a bit for each, the lowest for signal 1.
fn signals(process: &str, kind: &str) -> u64 {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(kind));
    line.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
}

fn is_ignored(signal: u32) -> bool {
    signals("self", "SigIgn:") & (1 << (signal - 1)) != 0
}

/// Whether the program takes signals by now, and no longer dies of them.
fn takes_signals(child: &Child) -> bool {
    signals(&child.id().to_string(), "SigCgt:") & (1 << (15 - 1)) != 0
}

fn samples(path: &Path) -> (u64, bool) {
    let mut recording = Recording::open(path).expect("it can be read");
    let mut count = 0;
    while let Some(samples) = recording.next_batch().expect("sound") {
        count += samples.len() as u64;
    }
    (count, recording.is_whole())
}

#[test]
fn an_interrupted_run_ends_its_parts_and_says_how_far_it_came() {
    let all = [(15, "SIGTERM", 143), (2, "SIGINT", 130), (1, "SIGHUP", 129)];
    // What this process has to ignore, as under `nohup`, the program ignores, too.
    for (signal, name, code) in all.into_iter().filter(|(signal, ..)| !is_ignored(*signal)) {
        let folder = folder();
        let path = |name: &str| folder.path().join(name);
        let mut run = start(folder.path(), &[&["run", "scene.toml", "--out", "."], &ENDLESS[..]].concat());
        wait_until(&mut run, || size(&path("scene.csv.part")) > 1 << 20);
        send(&signal.to_string(), &run);
        let output = run.wait_with_output().expect("it ends");
        let words = said(&output);
        assert_eq!(output.status.code(), Some(code), "{words}");
        assert_eq!(output.stdout, b"", "a run that was stopped has no results");
        let (kept, _) = samples(&path("scene.csv.part"));
        assert!(kept > 0 && kept < 4_000_001 && kept.is_multiple_of(8192), "whole batches: {kept}");
        let told = format!("scene: {name}: interrupted: the first {kept} of 4000001 samples, to ");
        assert!(words.contains(&told) && words.contains("polhode recover"), "{told:?} in {words}");
        for format in FORMATS {
            let (whole, part) = (path(&format!("scene.{format}")), path(&format!("scene.{format}.part")));
            assert!(!whole.exists() && words.contains(&format!("scene.{format}.part")), "{format}: {words}");
            assert_eq!(samples(&part), (kept, false), "{format}");
        }
        assert!(!path("scene.layout.json").exists() && !path("scene.layout.json.part").exists());
        for format in ["mcap", "rrd"] {
            let part = path(&format!("scene.{format}.part"));
            let found = contents(&part).expect("readable");
            let state = &found.details.iter().find(|(name, _)| name == "state").expect("a state").1;
            assert!(!found.is_whole && state.starts_with(&format!("interrupted: the first {kept} of")), "{state}");
            // Under a name that is not its own it is refused as it is, and not for want of an end.
            let other = path(&format!("other.{format}"));
            fs::copy(&part, &other).expect("room");
            assert_eq!(contents(&other).expect("its index is there").survey.expect("columns").samples, kept);
            assert!(Conversion::of(&other).is_err(), "{format}: not the whole run");
        }
        for format in FORMATS {
            let part = format!("scene.{format}.part");
            let recovered = super::asked(folder.path(), &["recover", &part, "--json"]);
            assert_eq!(recovered.status.code(), Some(0), "{format}: {}", said(&recovered));
            let report: Value = serde_json::from_slice(&recovered.stdout).expect("stdout is JSON");
            assert_eq!(report["kept"], kept, "{format}");
            assert_eq!(samples(&path(&format!("scene.{format}"))), (kept, true), "{format}");
        }
        let same = super::asked(folder.path(), &["digest", "scene.mcap", "scene.rrd"]);
        let digests: Vec<_> = String::from_utf8_lossy(&same.stdout).lines().map(|line| line[..64].to_owned()).collect();
        assert!(digests.len() == 2 && digests[0] == digests[1], "one run in both: {digests:?}");
    }
}

#[test]
fn scenes_after_an_interrupted_one_are_not_begun_and_those_before_are_whole() {
    let folder = folder();
    let scene = |duration: &str| SCENE.replace("duration_s = 1.0", &format!("duration_s = {duration}"));
    for (name, duration) in [("before", "1.0"), ("during", "4e3"), ("after", "1.0")] {
        fs::write(folder.path().join(format!("{name}.toml")), scene(duration)).expect("room");
    }
    let scenes = ["run", "before.toml", "during.toml", "after.toml", "--format", "csv", "--out", ".", "--json"];
    let mut command = program(folder.path());
    command.args(scenes).env("RAYON_NUM_THREADS", "1").stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut run = command.spawn().expect("the program starts");
    wait_until(&mut run, || size(&folder.path().join("during.csv.part")) > 1 << 20);
    send("TERM", &run);
    let output = run.wait_with_output().expect("it ends");
    let words = said(&output);
    assert_eq!(output.status.code(), Some(143), "{words}");
    assert!(words.contains("during: SIGTERM: interrupted: the first "), "{words}");
    assert!(words.contains("after: SIGTERM: interrupted: nothing is recorded"), "{words}");
    assert!(!words.contains("before"), "it is whole, and on stdout: {words}");
    let report: Value = serde_json::from_slice(&output.stdout).expect("stdout is JSON");
    assert_eq!((&report[0]["name"], &report[0]["samples"]), (&Value::from("before"), &Value::from(1001)));
    assert_eq!(report[1]["parts"], serde_json::json!(["./during.csv.part"]));
    assert_eq!((&report[2]["name"], &report[2]["samples"]), (&Value::from("after"), &Value::Null));
    let names: Vec<_> =
        ["after.csv", "after.csv.part", "during.csv"].map(|name| folder.path().join(name).exists()).into();
    assert_eq!((names, samples(&folder.path().join("before.csv"))), (vec![false; 3], (1001, true)));
}

/// A batch that takes hours: the first signal waits for its end, the second does not.
#[test]
fn a_second_signal_ends_the_run_at_once() {
    let folder = folder();
    let hours = ["--method", "rk4", "--step", "1e-7", "--sample-every", "1", "--duration", "5e3", "--format", "csv"];
    let mut run = start(folder.path(), &[&["run", "scene.toml", "--out", "."], &hours[..]].concat());
    wait_until(&mut run, || folder.path().join("scene.csv.part").exists());
    assert_eq!(insist("TERM", &mut run), Some(143));
    assert!(!folder.path().join("scene.csv").exists());
    let again = super::asked(folder.path(), &["run", "scene.toml", "--out", ".", "--format", "csv"]);
    assert_eq!(again.status.code(), Some(0), "nothing is in its way: {}", said(&again));
}

/// As under `nohup`, or in the background of a shell script.
#[test]
fn signals_that_were_ignored_at_the_start_stay_ignored() {
    let folder = folder();
    let mut command = Command::new("sh");
    command.current_dir(folder.path()).args(["-c", "trap '' INT HUP; exec \"$0\" \"$@\""]);
    command.arg(env!("CARGO_BIN_EXE_polhode")).args(["run", "scene.toml", "--out", ".", "--format", "csv", "--quiet"]);
    command.args(["--duration", "100"]);
    let mut run = command.spawn().expect("a shell");
    wait_until(&mut run, || folder.path().join("scene.csv.part").exists());
    send("HUP", &run);
    assert_eq!(insist("INT", &mut run), Some(0));
    assert_eq!(samples(&folder.path().join("scene.csv")), (100_001, true));
}

/// A command that goes over many things stops at the next, and clears away what it has made.
#[test]
fn goldens_that_are_interrupted_leave_nothing_behind() {
    let folder = folder();
    let temporary = folder.path().join("tmp");
    fs::create_dir(&temporary).expect("room");
    let mut command = program(folder.path());
    command.args(["golden", "--bless", "--folder", "goldens"]).env("TMPDIR", &temporary).stderr(Stdio::piped());
    let mut golden = command.stdout(Stdio::null()).spawn().expect("the program starts");
    let count = || fs::read_dir(&temporary).expect("a folder").count();
    wait_until(&mut golden, || count() > 0);
    send("TERM", &golden);
    let output = golden.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(143), "{}", said(&output));
    assert!(said(&output).contains("SIGTERM: interrupted: no golden is changed"), "{}", said(&output));
    assert_eq!(count(), 0);
    assert!(finals(&folder.path().join("goldens")).is_empty());
}

/// Hours of work, or a file that does not come: whatever it waits for, signals end it, and no file has a final name.
#[test]
fn every_command_is_ended_by_signals() {
    let hours =
        ["scene.toml", "--set=duration_s=1e9", "--set=sample_every_s=10", "--set=method=\"rk4\"", "--set=step_s=0.1"];
    let work: [&[&str]; 13] = [
        &["stress", "--full", "--plot", "new.svg"],
        &["bench", "scene.toml", "--duration", "1e5", "--budget", "1e6", "--csv", "new.csv"],
        &[&["plot", "-o", "new.svg"], &hours[..]].concat(),
        &[&["report", "-o", "new.html"], &hours[..]].concat(),
        &["inspect", "fifo.csv"],
        &["digest", "fifo.csv"],
        &["verify", "fifo.csv"],
        &["compare", "fifo.csv", "scene.csv", "--plot", "new.svg"],
        &["convert", "fifo.csv", "new.mcap"],
        &["recover", "fifo.csv.part"],
        &["plot", "fifo.csv", "-o", "new.svg"],
        &["report", "fifo.csv", "-o", "new.html"],
        &["plan", "scene.toml", "fifo.toml"],
    ];
    let folder = prepared();
    let mut pipes = Command::new("mkfifo");
    pipes.current_dir(folder.path()).args(["fifo.csv", "fifo.csv.part", "fifo.toml"]);
    assert!(pipes.status().expect("mkfifo").success());
    let before = finals(folder.path());
    for arguments in work {
        let mut command = start(folder.path(), arguments);
        while !takes_signals(&command) {
            assert!(command.try_wait().expect("it is ours").is_none(), "{arguments:?} ended by itself");
            std::thread::yield_now();
        }
        let code = insist("TERM", &mut command);
        let mut words = String::new();
        command.stderr.take().expect("piped").read_to_string(&mut words).expect("UTF-8");
        assert_eq!(code, Some(143), "{arguments:?}: {words}");
        assert!(!words.contains("panicked"), "{words}");
        assert_eq!(finals(folder.path()), before, "{arguments:?}");
    }
}
