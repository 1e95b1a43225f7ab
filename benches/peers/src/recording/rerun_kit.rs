use std::error::Error;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::Duration;

use polhode::scenario::Plan;
use rerun::{RecordingStreamBuilder, Scalars};

/// One `log` a channel and sample, all its numbers in one `Scalars`, which keeps f64; no picture. The kit as it comes:
/// it adds two timelines and batches on a thread of its own.
pub fn record(plan: &Plan, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let path = folder.join("run.rrd");
    let stream = RecordingStreamBuilder::new("peers").save(&path)?;
    let mut run = plan.start()?;
    let mut values = Vec::new();
    while let Some(samples) = run.next_batch()? {
        let body = &samples.bodies[0];
        for index in 0..samples.len() {
            stream.set_time("sim_time", Duration::from_nanos(samples.stamps_ns[index].unsigned_abs()));
            stream.set_time_sequence("step", (samples.first_index + index as u64).cast_signed());
            for channel in body.channels() {
                values.clear();
                values.extend(body.channel(channel).into_iter().flatten().map(|column| column[index]));
                stream.log(channel.row().name, &Scalars::new(values.iter().copied()))?;
            }
        }
    }
    stream.flush_blocking()?;
    drop(stream);
    File::open(&path)?.sync_all()?;
    Ok(vec![path])
}
