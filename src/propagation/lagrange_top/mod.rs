//! The Lagrange top in closed form: [`LagrangeTop`], a body of two equal moments under a force constant in the world
//! at a point of its axis.
//!
//! As in the torque-free case, constants and phases are worked out in double-double and a sample costs one pair of
//! theta series. With A = w + iz and B = x + iy of the quaternion from the body's axis to the vertical, |A|² and |B|²
//! are (1 ± u)/2, u the cosine of the tilt; so A and B are two shifted theta functions, each turning evenly.

mod homoclinic;
mod motion;
mod nutation;
mod roots;
mod start;
mod steady;
mod top;

pub use top::LagrangeTop;
