//! Methods with a fixed step: yardsticks, each one file, behind one driver that lands on samples and window edges.
//!
//! What everybody tries first (Euler, semi-implicit Euler), what textbooks offer (Runge–Kutta on vectors and on the
//! group), and geometric methods that keep what the motion keeps (splittings, discrete Moser–Veselov, Gauss
//! collocation, kicks between exact free motions). [`FixedStepMethod::information`] is the table of them.

mod composition;
mod equal_steps;
mod euler_naive;
mod euler_semi_implicit;
mod free_flow;
mod gauss;
mod kicked;
mod method;
mod moser_veselov;
mod planar_rotations;
mod preprocessing;
mod propagator;
mod rkmk4;
mod scheme;

pub use method::{Coverage, FixedStepMethod, Information};
pub use propagator::FixedStep;
pub(super) use scheme::Scheme;
