//! What SIGINT, SIGTERM and SIGHUP do: a command that is [`Patient`] is told, and stops where nothing is half done; a second
//! signal, and the first one elsewhere, ends the program at once, as a kill does.

use std::marker::PhantomData;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

/// Whether the next signal ends the program at once.
static ENDS_AT_ONCE: AtomicBool = AtomicBool::new(true);
/// The number of the signal that came last; 0 is none.
static RECEIVED: AtomicUsize = AtomicUsize::new(0);

#[cfg(not(unix))]
const SIGNALS: [i32; 2] = [SIGINT, SIGTERM];
#[cfg(unix)]
const SIGNALS: [i32; 3] = [SIGINT, SIGTERM, signal_hook::consts::SIGHUP];

/// Takes the signals from now on, but for those that whoever started the program has it ignore, as `nohup` does.
pub fn watch() {
    let ignored = ignored();
    for signal in SIGNALS.into_iter().filter(|signal| ignored & (1 << (signal - 1)) == 0) {
        // Where one cannot be taken it does what it always did. In this order, the second signal is one too many.
        let _ = flag::register_conditional_shutdown(signal, 128 + signal, &ENDS_AT_ONCE)
            .and_then(|_| flag::register(signal, &ENDS_AT_ONCE))
            .and_then(|_| flag::register_usize(signal, &RECEIVED, signal.unsigned_abs() as usize));
    }
}

/// A bit for each signal that is ignored, where the system tells it in words.
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    line.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
}

/// While it lives, the first signal is only noted: who holds it asks [`signal`] between its steps.
#[derive(Debug)]
pub struct Patient(PhantomData<()>);

impl Patient {
    pub fn new() -> Self {
        ENDS_AT_ONCE.store(false, Ordering::SeqCst);
        Self(PhantomData)
    }
}

impl Drop for Patient {
    fn drop(&mut self) {
        ENDS_AT_ONCE.store(true, Ordering::SeqCst);
    }
}

/// The signal that wants the program to stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Signal(u8);

/// Whether there is one.
pub fn signal() -> Option<Signal> {
    u8::try_from(RECEIVED.load(Ordering::SeqCst)).ok().filter(|number| *number > 0).map(Signal)
}

impl Signal {
    /// As a shell tells of a program that it has killed: 130 for SIGINT, 143 for SIGTERM, 129 for SIGHUP.
    pub const fn exit_code(self) -> u8 {
        128 + self.0
    }
}

impl std::fmt::Display for Signal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match i32::from(self.0) {
            SIGINT => f.write_str("SIGINT"),
            SIGTERM => f.write_str("SIGTERM"),
            1 => f.write_str("SIGHUP"),
            number => write!(f, "signal {number}"),
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn exit_codes_are_those_of_shells() {
        let codes = SIGNALS.map(|signal| u8::try_from(signal).map(|number| Signal(number).exit_code()).ok());
        assert_eq!(codes, [Some(130), Some(143), Some(129)]);
    }
}
