//! The theta functions of torque-free rotation, by whichever nome is small.

mod flips;
mod nome;
mod pair;

pub use flips::FlipSum;
pub use nome::NomeSeries;
pub use pair::{Theta, ThetaPair};
