//! Processor time, wall time and memory of this process.

use std::time::{Duration, Instant};

/// µs a sample.
#[derive(Debug, Clone, Copy)]
pub struct Cost {
    /// Of all threads, the kernel's work for them included.
    pub cpu: f64,
    pub wall: f64,
}

/// What `work` on so many samples costs.
pub fn cost(samples: u32, work: &mut impl FnMut()) -> Cost {
    let (cpu, wall) = (cpu_clock(), Instant::now());
    work();
    let per_sample = |time: Duration| 1e6 * time.as_secs_f64() / f64::from(samples);
    Cost { cpu: per_sample(cpu_clock().saturating_sub(cpu)), wall: per_sample(wall.elapsed()) }
}

pub fn median(costs: &[Cost], of: impl Fn(&Cost) -> f64) -> f64 {
    let mut values: Vec<f64> = costs.iter().map(of).collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[cfg(unix)]
fn cpu_clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    let seconds = u64::try_from(time.tv_sec).expect("not negative");
    Duration::new(seconds, u32::try_from(time.tv_nsec).expect("below 1e9"))
}

#[cfg(not(unix))]
use polhode::study::wall_clock as cpu_clock;

/// The most memory that this process has held so far, bytes, where the system tells.
pub fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse::<u64>().ok().map(|kibibytes| 1024 * kibibytes)
}
