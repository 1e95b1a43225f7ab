//! Instructions of this same program, counted by callgrind.
//!
//! Its processor has AVX2 where the real one has, and never AVX-512: code that chooses by processor takes the AVX2 path.

use std::process::Command;

/// The argument that makes this program run one case.
pub const RUN: &str = "--run-case";

pub fn is_there() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Instructions of one of `count` more repetitions of a case.
pub fn count(name: &str, count: u32) -> f64 {
    (total(name, 2 * count) - total(name, count)) / f64::from(count)
}

fn total(name: &str, count: u32) -> f64 {
    let program = std::env::current_exe().expect("this program has a path");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args([RUN, name, &count.to_string()])
        .output()
        .expect("valgrind starts");
    let remarks = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{remarks}");
    let total = remarks.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok());
    total.unwrap_or_else(|| panic!("no count in {remarks}"))
}
