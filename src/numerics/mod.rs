//! Mathematics without bodies in it: elliptic functions, rotation maps, double-double, series, tapes.

mod compensated;
mod convolution;
mod double_double;
mod elementary;
mod elliptic;
mod four;
mod lanes;
pub mod so3;
mod tape;
mod theta;
mod turn;

pub use compensated::Compensated;
pub use convolution::convolution;
pub use double_double::{DoubleDouble, two_prod, two_sum};
pub use elementary::exp_of_negative;
pub use elliptic::{carlson_rf, complete_k, complete_k_of_nome, nome};
pub use four::{Four, Kernel, in_registers};
pub use lanes::vectorised;
pub use tape::{Expansion, Node, Operation, Scalar, Tape};
pub use theta::{
    FlipSum, Jacobi, JacobiFlips, JacobiSeries, NomeSeries, ShiftedFlips, ShiftedPair, ShiftedSeries, Theta, ThetaPair,
    TwoShifts,
};
pub use turn::{Phase, Turn};
