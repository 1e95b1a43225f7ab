use nalgebra::Vector3;

use super::{PointForce, total_force, total_moment};
use crate::body::BodyError;

/// A spring between two particles: the simplest internal force, along the line that joins them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// The particles it joins, from 0.
    pub ends: [usize; 2],
    /// N/m.
    pub stiffness: f64,
    /// Length without force, m.
    pub rest_length: f64,
}

/// Total force and total moment about a point, world axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resultant {
    /// N.
    pub force: Vector3<f64>,
    /// N m.
    pub moment: Vector3<f64>,
}

/// The two opposite forces of each spring on particles at `positions` (world axes, m): first end, second end, next.
///
/// # Errors
/// If a spring's end does not exist, or both are in one place, where the force has no direction.
pub fn spring_forces(positions: &[Vector3<f64>], springs: &[Spring]) -> Result<Vec<PointForce>, BodyError> {
    let mut forces = Vec::with_capacity(2 * springs.len());
    for (index, spring) in springs.iter().enumerate() {
        let [first, second] = spring.ends;
        let refused = BodyError::Spring { index, ends: spring.ends, particles: positions.len() };
        let (Some(from), Some(to)) = (positions.get(first), positions.get(second)) else { return Err(refused) };
        let between = to - from;
        let length = between.norm();
        if length <= 0.0 {
            return Err(refused);
        }
        let pull = between * (spring.stiffness * (length - spring.rest_length) / length);
        forces.push(PointForce { force: pull, point: *from });
        forces.push(PointForce { force: -pull, point: *to });
    }
    Ok(forces)
}

/// Σ F and Σ (x − X) × F of all springs about `reference` = X: zero but for rounding, whatever the springs.
///
/// Opposite forces on one line cancel in both sums; this is why a body's inner forces do not move it.
///
/// # Errors
/// As [`spring_forces`].
pub fn internal_resultant(
    positions: &[Vector3<f64>],
    springs: &[Spring],
    reference: &Vector3<f64>,
) -> Result<Resultant, BodyError> {
    let forces = spring_forces(positions, springs)?;
    Ok(Resultant { force: total_force(&forces), moment: total_moment(&forces, reference) })
}
