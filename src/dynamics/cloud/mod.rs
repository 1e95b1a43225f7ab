//! Particles with a spring between every pair: what a rigid body is made of, before it is rigid.

mod cloud;
mod stiffness;

pub use cloud::{SpringCloud, Springs};
