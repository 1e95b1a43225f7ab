use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::BodyError;

/// The diagonal of the inertia tensor in principal axes, kg m²: positive, and no one above the sum of the others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalMoments(Vector3<f64>);

impl PrincipalMoments {
    /// Room for rounding in the triangle inequality, relative: a tilted lamina's I₃ = I₁ + I₂ may be off by 5 ε.
    const LAMINA_ROUNDING: f64 = 16.0 * f64::EPSILON;

    /// From three moments in kg m².
    ///
    /// # Errors
    /// If one is not positive and finite, or exceeds the sum of the other two by more than rounding.
    pub fn new(moments: [f64; 3]) -> Result<Self, BodyError> {
        if moments.iter().any(|moment| !moment.is_finite() || *moment <= 0.0) {
            return Err(BodyError::MomentNotPositive(moments));
        }
        let largest = moments.iter().copied().fold(0.0, f64::max);
        let [a, b, c] = moments.map(|moment| moment / largest);
        if a + b + c - 2.0 < -Self::LAMINA_ROUNDING {
            return Err(BodyError::TriangleInequality(moments));
        }
        Ok(Self(Vector3::from(moments)))
    }

    /// The three moments, kg m².
    #[must_use]
    pub fn vector(self) -> Vector3<f64> {
        self.0
    }
}

/// All of a body that its motion depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct MassProperties {
    /// kg; unknown where only moments of inertia were given.
    pub mass: Option<f64>,
    /// From the body's origin of coordinates, in body axes, m.
    pub centre_of_mass: Vector3<f64>,
    /// About the centre of mass, or about the pivot where [`Self::about`] says so.
    pub moments: PrincipalMoments,
    /// Turns principal axes into body axes; the identity where the tensor was given diagonal.
    pub body_from_principal: UnitQuaternion<f64>,
    /// The point that `moments` are about, from the body's origin of coordinates, in body axes, m.
    pub about: Vector3<f64>,
}

impl MassProperties {
    /// The inertia tensor about [`Self::about`], in body axes, kg m².
    #[must_use]
    pub fn tensor(&self) -> Matrix3<f64> {
        let rotation = self.body_from_principal.to_rotation_matrix();
        rotation * Matrix3::from_diagonal(&self.moments.vector()) * rotation.inverse()
    }
}
