//! What a sample costs in a long recording, and how far that is from the floor: prints the table of `docs/performance.md`.
//!
//! `cargo bench --bench recordings`. Processor time of all threads, the kernel's included, files synced to the disk;
//! medians of rounds in turn. Fails if memory grows with the length of a recording, indexes aside.

mod clock;
mod floor;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clock::{Cost, cost, median, peak_memory};
use polhode::recording::Recorder;
use polhode::scenario::{Plan, Scenario};

/// The scene `dzhanibekov` at a hundred samples a second.
const SAMPLES: u32 = 1_000_000;
const ROUNDS: usize = 3;

/// What a recording may take, bytes.
const MEMORY: u64 = 100_000_000;

/// What may remain of a sample, bytes: its share in the indexes at the files' ends, which a file's chunks need.
const INDEXES: u64 = 8;

/// What the issue of the recordings asks for at most, µs a sample.
const RUNS: [(&str, &[&str], f64); 3] =
    [(".mcap", &["mcap"], 1.1), (".rrd", &["rrd"], 1.0), ("both", &["mcap", "rrd"], 2.2)];

fn main() -> ExitCode {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let memory = memory(folder.path());
    let (all, attitude) = (plan(SAMPLES, &[]), plan(SAMPLES, &["channels=[\"attitude\"]"]));
    println!("{:<28} {:>8} {:>8} {:>9}", "µs a sample", "CPU", "wall", "target");
    let motion = show("motion and channels alone", &rounds(|| record(&all, folder.path(), &[])), None);
    let headings = format!("| a sample of | bytes | motion | floor: disk |{} all | attitude alone |", floor::HEADINGS);
    let mut table = vec![headings, format!("|{}", "---|".repeat(9))];
    for (name, extensions, target) in RUNS {
        let whole = show(name, &rounds(|| record(&all, folder.path(), extensions)), Some(target));
        let floors = floor::of(&paths(folder.path(), extensions), SAMPLES);
        let part =
            show(&format!("{name}, attitude alone"), &rounds(|| record(&attitude, folder.path(), extensions)), None);
        for (what, microseconds) in [("disk", floors.disk), ("memory", floors.copy)].into_iter().chain(floors.packing())
        {
            println!("{:<28} {microseconds:>8.3}", format!("{name}, floor: {what}"));
        }
        let share = |microseconds: f64| match microseconds {
            0.0 => "–".to_owned(),
            _ => format!("{:.0} %", 100.0 * microseconds / whole.cpu),
        };
        let packing = floors.packing().map(|(_, cost)| share(cost));
        let cells = [format!("{:.0}", floors.bytes), share(motion.cpu), share(floors.disk), share(floors.copy)];
        let cells = cells.into_iter().chain(packing).chain(["100 %".to_owned(), share(part.cpu)]);
        table.push(format!("| {name} | {} |", cells.collect::<Vec<_>>().join(" | ")));
    }
    println!("\n{}", table.join("\n"));
    memory
}

/// Whether ten times the samples take no more memory than their indexes need.
fn memory(folder: &Path) -> ExitCode {
    let peak_after = |samples| {
        record(&plan(samples, &[]), folder, &["mcap", "rrd"]);
        peak_memory()
    };
    let (Some(short), Some(long)) = (peak_after(SAMPLES / 10), peak_after(SAMPLES)) else {
        println!("memory: this system does not tell");
        return ExitCode::SUCCESS;
    };
    println!("memory at most: {short} bytes for {} samples, {long} for {SAMPLES}", SAMPLES / 10);
    if long > MEMORY || long - short > INDEXES * u64::from(SAMPLES) {
        println!("that is more than {INDEXES} bytes a sample for indexes, or above {MEMORY} bytes");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

fn plan(samples: u32, assignments: &[&str]) -> Plan {
    let grid = [format!("duration_s={}", 0.01 * f64::from(samples - 1)), "sample_every_s=0.01".to_owned()];
    let assignments: Vec<_> = grid.into_iter().chain(assignments.iter().map(ToString::to_string)).collect();
    Plan::new(&Scenario::named("dzhanibekov", &assignments).expect("it comes with the program")).expect("it plans")
}

fn paths(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    extensions.iter().map(|extension| folder.join("run").with_extension(extension)).collect()
}

/// A whole run; without extensions in memory.
fn record(plan: &Plan, folder: &Path, extensions: &[&str]) {
    let paths = paths(folder, extensions);
    let mut recorder = Recorder::create(plan, &paths, true).expect("a recorder");
    let mut run = plan.start().expect("it starts");
    while let Some(samples) = run.next_batch().expect("it runs") {
        recorder.write(samples).expect("it is written");
    }
    recorder.finish().expect("it is whole");
}

fn rounds(mut work: impl FnMut()) -> Vec<Cost> {
    (0..ROUNDS).map(|_| cost(SAMPLES, &mut work)).collect()
}

/// Prints and returns the medians.
fn show(name: &str, costs: &[Cost], target: Option<f64>) -> Cost {
    let cost = Cost { cpu: median(costs, |cost| cost.cpu), wall: median(costs, |cost| cost.wall) };
    let verdict = target
        .map_or(String::new(), |target| format!("{target:>5.1} {}", if cost.cpu <= target { "met" } else { "missed" }));
    println!("{name:<28} {:>8.3} {:>8.3} {verdict:>9}", cost.cpu, cost.wall);
    cost
}
