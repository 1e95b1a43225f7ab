//! What set-up, samples, steps and recordings cost.
//!
//! `cargo bench --no-default-features --bench costs` times the physics; with default features, recording too.

mod motions;
#[path = "../problems/mod.rs"]
mod problems;
#[cfg(feature = "cli")]
mod recordings;
#[path = "../problems/top.rs"]
mod top;

fn main() {
    divan::main();
}
