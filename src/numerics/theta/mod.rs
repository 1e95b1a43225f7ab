//! The theta functions of torque-free rotation and of the Lagrange top, by whichever nome is small.

mod flips;
mod nome;
mod pair;
mod shifted_flips;
mod shifted_series;
mod two_shifts;

pub use flips::FlipSum;
pub use nome::NomeSeries;
pub use pair::{Theta, ThetaPair};
pub use shifted_flips::ShiftedFlips;
pub use shifted_series::ShiftedSeries;
pub use two_shifts::{ShiftedPair, TwoShifts};
