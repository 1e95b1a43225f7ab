//! No file imports a floor above its own.

use std::fs;
use std::path::{Path, PathBuf};

/// From the ground up.
const FLOORS: [&str; 12] = [
    "numerics",
    "body",
    "dynamics",
    "propagation",
    "telemetry",
    "scenario",
    "recording",
    "comparison",
    "golden",
    "plot",
    "study",
    "cli",
];

#[test]
fn imports_point_down() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut violations = Vec::new();
    let mut seen = 0;
    for (level, floor) in FLOORS.iter().enumerate() {
        for file in rust_files(&source.join(floor)) {
            let text = fs::read_to_string(&file).expect("source can be read");
            seen += 1;
            for above in &FLOORS[level + 1..] {
                let import = format!("crate::{above}");
                for (number, line) in text.lines().enumerate().filter(|(_, line)| line.contains(&import)) {
                    violations.push(format!("{}:{}: {}", file.display(), number + 1, line.trim()));
                }
            }
        }
    }
    assert!(seen > 50, "only {seen} files were looked at");
    assert!(violations.is_empty(), "{}", violations.join("\n"));
}

#[test]
fn files_stay_small() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for file in rust_files(&source) {
        let lines = fs::read_to_string(&file).expect("source can be read").lines().count();
        let is_table = file.file_name().is_some_and(|name| name == "tableau.rs" || name == "tableaus.rs");
        assert!(lines <= 400 || is_table, "{} has {lines} lines: it holds two ideas", file.display());
    }
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let paths = entries.map(|entry| entry.expect("an entry can be read").path());
    paths
        .flat_map(|path| if path.is_dir() { rust_files(&path) } else { vec![path] })
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}
