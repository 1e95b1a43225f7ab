//! polhode's recorder beside the kits of the viewers' makers: processor time and bytes per sample, the same columns of
//! the same run.
//!
//! `cargo run --release --features recording --bin recording` in this folder; `--markdown` as docs/performance.md has it.

mod foxglove_kit;
mod measure;
mod polhode_recorder;
mod rerun_kit;
mod scene;

use std::error::Error;

use measure::{Measured, measure};

/// What a kit is given; polhode's files are ten times as long, as they take as long to write.
const KIT_SAMPLES: u32 = 100_000;
const OUR_SAMPLES: u32 = 1_000_000;

fn main() -> Result<(), Box<dyn Error>> {
    let is_markdown = match std::env::args().nth(1).as_deref() {
        None => false,
        Some("--markdown") => true,
        Some(other) => return Err(format!("{other}: the only option is --markdown").into()),
    };
    let [rerun, foxglove, rrd, mcap, both] = measure([
        (KIT_SAMPLES, &rerun_kit::record),
        (KIT_SAMPLES, &foxglove_kit::record),
        (OUR_SAMPLES, &|plan, folder| polhode_recorder::record(plan, folder, &["rrd"])),
        (OUR_SAMPLES, &|plan, folder| polhode_recorder::record(plan, folder, &["mcap"])),
        (OUR_SAMPLES, &|plan, folder| polhode_recorder::record(plan, folder, &["mcap", "rrd"])),
    ])?;
    let lines = [
        ("`rerun` SDK, a row a channel to `.rrd`", rerun, rrd),
        ("polhode, `.rrd`", rrd, rrd),
        ("`foxglove` SDK, five messages to `.mcap`", foxglove, mcap),
        ("polhode, `.mcap`", mcap, mcap),
        ("polhode, both at once", both, both),
    ];
    if is_markdown {
        println!("| recorder | bytes per sample | time, over polhode's |\n|---|---|---|");
    }
    for (name, Measured { time_s, bytes }, ours) in lines {
        let ratio = time_s / ours.time_s;
        if is_markdown {
            println!("| {name} | {bytes:.0} | {ratio:.1}× |");
        } else {
            println!("{name:<42} {:>8.2} µs {bytes:>6.0} B {ratio:>6.1}×", 1e6 * time_s);
        }
    }
    Ok(())
}
