//! Particles with a spring between every pair: what a rigid body is made of, before it is rigid.

mod spring_cloud;
mod stiffness;

pub use spring_cloud::{SpringCloud, Springs};
