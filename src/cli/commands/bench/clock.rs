//! The processor's time of this thread where the system tells it: other programs do not count.

#[cfg(not(unix))]
pub use crate::study::wall_clock as clock;
#[cfg(unix)]
use std::time::Duration;

#[cfg(unix)]
pub const NAME: &str = "CPU time";
#[cfg(not(unix))]
pub const NAME: &str = "wall time";

/// Spent by this thread so far.
#[cfg(unix)]
pub fn clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    // The system promises neither to be negative.
    let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
    Duration::new(seconds, u32::try_from(time.tv_nsec).unwrap_or(0))
}
