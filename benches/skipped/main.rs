//! What a plan leaves out, each with and without: prints the table of `docs/performance.md`.
//!
//! `cargo bench --bench skipped`. Both sides of a ratio run in turn, on one thread, by the processor's clock; medians.

mod motions;
#[path = "../problems/mod.rs"]
mod problems;
mod recordings;

use std::time::Duration;

use polhode::study::interleaved;

/// What a pair may take, s.
const BUDGET_S: f64 = 1.5;

/// One thing done.
type Work = Box<dyn FnMut()>;

/// One thing that can be left out.
struct Pair {
    left_out: &'static str,
    of: &'static str,
    with: Work,
    without: Work,
}

fn main() {
    println!("| left out | of | with / without |");
    println!("|---|---|---|");
    let folder = tempfile::tempdir().expect("a temporary folder");
    for Pair { left_out, of, with, without } in motions::pairs().into_iter().chain(recordings::pairs(folder.path())) {
        let medians: Vec<_> = interleaved(&mut [with, without], clock, BUDGET_S);
        let ratio = medians[0].median_s / medians[1].median_s;
        let ratio = if ratio < 9.95 { format!("{ratio:.1}") } else { format!("{ratio:.0}") };
        println!("| {left_out} | {of} | {ratio}× |");
    }
}

/// The processor's time of this thread.
#[cfg(unix)]
fn clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    let seconds = u64::try_from(time.tv_sec).expect("not negative");
    Duration::new(seconds, u32::try_from(time.tv_nsec).expect("below 1e9"))
}

#[cfg(not(unix))]
use polhode::study::wall_clock as clock;
