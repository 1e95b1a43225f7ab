//! Prints every trajectory of the tests as a hash of its bits, one a line.

#[allow(dead_code, reason = "the tests use all of it")]
#[path = "../suite/motions.rs"]
mod motions;
#[path = "../suite/trajectories/mod.rs"]
mod trajectories;

fn main() {
    for line in trajectories::lines() {
        println!("{line}");
    }
}
