//! What set-up, samples, steps and channels cost, and what is saved by leaving them out.
//!
//! `cargo bench --no-default-features` times the physics; with default features, recording too.

mod motions;
#[cfg(feature = "cli")]
mod recordings;
mod skipped;

fn main() {
    divan::main();
}
