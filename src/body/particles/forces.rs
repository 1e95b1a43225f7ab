use nalgebra::Vector3;

/// A force and the point where it acts, world axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointForce {
    /// F, N.
    pub force: Vector3<f64>,
    /// x, m.
    pub point: Vector3<f64>,
}

impl PointForce {
    /// τ = (x − X) × F about `reference` = X, N m.
    #[must_use]
    pub fn moment_about(&self, reference: &Vector3<f64>) -> Vector3<f64> {
        (self.point - reference).cross(&self.force)
    }
}

/// F = Σ Fᵢ, N.
#[must_use]
pub fn total_force(forces: &[PointForce]) -> Vector3<f64> {
    forces.iter().map(|point_force| point_force.force).sum()
}

/// T = Σ (xᵢ − X) × Fᵢ about `reference` = X, N m.
#[must_use]
pub fn total_moment(forces: &[PointForce], reference: &Vector3<f64>) -> Vector3<f64> {
    forces.iter().map(|force| force.moment_about(reference)).sum()
}

/// A = F / M, m/s²: the centre of mass moves as if the whole mass, kg, were there and all forces, N, acted there.
#[must_use]
pub fn acceleration_of_centre(total_force: &Vector3<f64>, mass: f64) -> Vector3<f64> {
    total_force / mass
}
