//! The committed counts: a line that names the compiler, then a line for each case.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

pub struct Row {
    pub name: String,
    /// Instructions each.
    pub count: f64,
}

pub struct Table {
    /// Counts of another compiler, or another processor's, say nothing.
    pub compiler: String,
    pub rows: Vec<Row>,
}

/// The compiler's name and version, and the processor's kind.
pub fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    let version = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned()).unwrap_or_default();
    format!("{version}, {}", std::env::consts::ARCH)
}

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("benches/instructions/counts.txt")
}

impl Table {
    pub fn read() -> Self {
        let text = fs::read_to_string(path()).unwrap_or_default();
        let mut lines = text.lines();
        let compiler = lines.next().unwrap_or_default().to_owned();
        let row = |line: &str| {
            let (count, name) = line.trim().split_once(' ')?;
            Some(Row { name: name.to_owned(), count: count.parse().ok()? })
        };
        Self { compiler, rows: lines.filter_map(row).collect() }
    }

    /// With these rows in place of those of their names; what this build leaves out stays.
    pub fn with(mut self, found: Vec<Row>, compiler: String) -> Self {
        for row in found {
            match self.rows.iter_mut().find(|kept| kept.name == row.name) {
                Some(kept) => *kept = row,
                None => self.rows.push(row),
            }
        }
        Self { compiler, ..self }
    }

    pub fn write(&self) {
        let rows = self.rows.iter().map(|row| format!("{:9.0} {}\n", row.count, row.name));
        let text = format!("{}\n{}", self.compiler, rows.collect::<String>());
        fs::write(path(), text).expect("benches/instructions can be written");
    }
}
