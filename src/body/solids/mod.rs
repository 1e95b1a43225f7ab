//! Simple solids, alone and put together.

mod shape;
mod solid;
#[cfg(test)]
mod tests;

pub use shape::Shape;
pub use solid::{Solid, mass_properties_of};
