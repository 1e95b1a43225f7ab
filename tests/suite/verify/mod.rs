//! `comparison::verify`: what is right is found right, and each naive method is found out by name.

mod causes;
mod clean;
mod engine;
mod engines;
#[cfg(feature = "cli")]
mod program;
mod readings;
mod unexplained;
