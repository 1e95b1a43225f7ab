use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Duration;

use polhode::scenario::Plan;

use crate::scene;

/// Runs a plan into new files of a folder, on the disk when it returns.
pub type Record<'a> = &'a dyn Fn(&Plan, &Path) -> Result<Vec<PathBuf>, Box<dyn Error>>;

/// What a sample costs.
#[derive(Clone, Copy)]
pub struct Measured {
    /// All threads of the process, s.
    pub time_s: f64,
    pub bytes: f64,
}

const ROUNDS: usize = 3;

/// Each recorder with as many samples as it is given, in turn; medians.
pub fn measure<const N: usize>(recorders: [(u32, Record); N]) -> Result<[Measured; N], Box<dyn Error>> {
    let mut times = vec![Vec::new(); N];
    let mut bytes = [0.0; N];
    for _ in 0..ROUNDS {
        for (index, (samples, record)) in recorders.iter().enumerate() {
            let (plan, folder) = (scene::plan(*samples)?, tempfile::tempdir()?);
            let start = process_clock();
            let files = record(&plan, folder.path())?;
            times[index].push((process_clock() - start).as_secs_f64() / f64::from(*samples));
            let sizes = files.iter().map(|file| Ok(std::fs::metadata(file)?.len()));
            bytes[index] = sizes.sum::<std::io::Result<u64>>()? as f64 / f64::from(*samples);
        }
    }
    times.iter_mut().for_each(|times| times.sort_by(f64::total_cmp));
    Ok(std::array::from_fn(|index| Measured { time_s: times[index][ROUNDS / 2], bytes: bytes[index] }))
}

/// Processor time of all threads: kits encode and write on threads of their own.
fn process_clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
