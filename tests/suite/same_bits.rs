//! Trajectories have the same bits everywhere: in debug and release, for any processor, batch size and thread count.
//!
//! `tests/bits/trajectories.txt` holds the hashes that every build must find. Where a change is meant,
//! `POLHODE_BLESS=1 cargo test same_bits` writes them anew; the changelog then names what changed.

use std::path::Path;
use std::process::Command;
use std::{fs, thread};

use crate::trajectories::lines;

/// Says which lines differ.
fn compare(expected: &[String], found: &[String], who: &str) {
    let missing = expected.iter().filter(|line| !found.contains(line)).map(|line| format!("- {line}\n"));
    let new = found.iter().filter(|line| !expected.contains(line)).map(|line| format!("+ {line}\n"));
    assert!(expected == found, "{who}:\n{}", missing.chain(new).collect::<String>());
}

#[test]
fn this_build_finds_the_hashes_of_every_other() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bits/trajectories.txt");
    let found = lines();
    assert!(found.len() >= 100, "only {} trajectories", found.len());
    if std::env::var_os("POLHODE_BLESS").is_some() {
        fs::write(&file, found.join("\n") + "\n").expect("tests/bits can be written");
    }
    let kept = fs::read_to_string(&file).expect("the file of hashes");
    compare(&kept.lines().map(str::to_owned).collect::<Vec<_>>(), &found, "kept and now");
}

#[test]
fn threads_side_by_side_leave_every_bit() {
    let alone = lines();
    thread::scope(|scope| {
        let side_by_side = [(); 3].map(|()| scope.spawn(lines));
        for thread in side_by_side {
            compare(&alone, &thread.join().expect("no panic"), "alone and side by side");
        }
    });
}

/// Builds `tests/bits` optimised and for all that this machine's processor can, then compares. The first time takes a
/// minute or two; later, what did not change is not built again.
#[test]
fn an_optimised_build_for_this_processor_has_the_same_bits() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bits-native");
    let output = Command::new(env!("CARGO"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["run", "--package", "bits", "--release", "--offline", "--locked", "--quiet"])
        .args(["--config", "profile.release.debug=false", "--target-dir"])
        .arg(target)
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env("RUSTFLAGS", "-C target-cpu=native")
        .output()
        .expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let other: Vec<_> = String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect();
    compare(&lines(), &other, "this build and an optimised one for this processor");
}
