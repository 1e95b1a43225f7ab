//! The theta functions of torque-free rotation and of the Lagrange top, by whichever nome is small.

mod flips;
mod nome;
mod pair;
mod shifted_flips;
mod shifted_series;
mod two_shifts;

pub use flips::{FlipSum, JacobiFlips};
pub use nome::{JacobiSeries, NomeSeries};
pub use pair::{Jacobi, Theta, ThetaPair};
pub use shifted_flips::ShiftedFlips;
pub use shifted_series::ShiftedSeries;
pub use two_shifts::{ShiftedPair, TwoShifts};
