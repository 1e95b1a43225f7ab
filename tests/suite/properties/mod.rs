//! Laws over any body, rate, attitude, load and span, tried on random ones and shrunk where they fail.
//!
//! The same cases every time; `PROPTEST_CASES=100000 cargo test --release --test suite properties` tries more, and
//! `PROPTEST_RNG_SEED` others. What ever failed is kept in `tests/proptest-regressions` and tried first.
//!
//! Bounds are in roundings of the answer, or, where the motion itself magnifies, in how far a start moves it that is one
//! rounding off: [`motions::sensitivity`].

mod batches;
mod closed_forms;
mod continuity;
mod equivalence;
mod free;
mod montgomery;
mod motions;
mod starts;
mod stepped;
mod units;

use proptest::test_runner::{Config, FileFailurePersistence, RngSeed};

/// Of so many cases, unless the environment says otherwise.
fn cases(usual: u32) -> Config {
    let defaults = Config::default();
    let is_set = std::env::var_os("PROPTEST_CASES").is_some();
    Config {
        cases: if is_set { defaults.cases } else { usual },
        // They are a part of all cases, not a number of them.
        max_global_rejects: u32::MAX,
        max_local_rejects: u32::MAX,
        rng_seed: if defaults.rng_seed == RngSeed::Random { RngSeed::Fixed(1765) } else { defaults.rng_seed },
        failure_persistence: Some(Box::new(FileFailurePersistence::SourceParallel("proptest-regressions"))),
        ..defaults
    }
}
