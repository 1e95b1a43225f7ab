//! Runge–Kutta methods: yardsticks, and the way for a library user's own [`TorqueModel`](crate::dynamics::TorqueModel).

mod dop853;
mod dormand_prince;
mod rk4;
mod tableau;

pub use dop853::Dop853;
pub(in crate::propagation) use rk4::ClassicRk4;
