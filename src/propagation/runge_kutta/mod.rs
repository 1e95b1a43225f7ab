//! Runge–Kutta methods: yardsticks, and the way for a library user's own [`TorqueModel`](crate::dynamics::TorqueModel).

mod dop853;
mod dormand_prince;
mod equations;
mod rk4;
mod tableau;

pub use dop853::Dop853;
pub use rk4::Rk4;
