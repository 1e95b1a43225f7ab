//! How good a run is: certificates of its error, against paths of higher precision.

mod certificate;
mod deviation;

pub use certificate::certify;
