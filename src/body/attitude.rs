use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::BodyError;

/// How a body is turned: the rotation that takes vectors from body axes to world axes.
///
/// Hamilton convention, components in the order w, x, y, z. `q` and `-q` are the same attitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude(UnitQuaternion<f64>);

impl Attitude {
    /// How far from 1 the length of a typed quaternion may be: rounding of twelve printed digits.
    pub const LENGTH_TOLERANCE: f64 = 1e-12;

    /// The attitude `[w, x, y, z]`, normalised to the last bit.
    ///
    /// # Errors
    /// If a component is not finite or the length is further than [`Self::LENGTH_TOLERANCE`] from 1.
    pub fn new(wxyz: [f64; 4]) -> Result<Self, BodyError> {
        let [w, x, y, z] = wxyz;
        if wxyz.iter().any(|component| !component.is_finite()) {
            return Err(BodyError::NotFinite { quantity: "attitude quaternion", value: wxyz.to_vec() });
        }
        let quaternion = Quaternion::new(w, x, y, z);
        let length = quaternion.norm();
        if (length - 1.0).abs() > Self::LENGTH_TOLERANCE {
            return Err(BodyError::NotUnit { quaternion: wxyz, length, tolerance: Self::LENGTH_TOLERANCE });
        }
        Ok(Self(UnitQuaternion::new_normalize(quaternion)))
    }

    /// Body axes along world axes.
    #[must_use]
    pub fn identity() -> Self {
        Self(UnitQuaternion::identity())
    }

    /// The attitude with this rotation from body to world.
    #[must_use]
    pub fn from_world_from_body(world_from_body: UnitQuaternion<f64>) -> Self {
        Self(world_from_body)
    }

    /// The rotation that takes body components to world components.
    #[must_use]
    pub fn world_from_body(self) -> UnitQuaternion<f64> {
        self.0
    }

    /// The quaternion as `[w, x, y, z]`.
    #[must_use]
    pub fn wxyz(self) -> [f64; 4] {
        [self.0.w, self.0.i, self.0.j, self.0.k]
    }

    /// World components of a vector given in body axes.
    #[must_use]
    pub fn to_world(self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.0 * in_body
    }

    /// Body components of a vector given in world axes.
    #[must_use]
    pub fn to_body(self, in_world: &Vector3<f64>) -> Vector3<f64> {
        self.0.inverse_transform_vector(in_world)
    }

    /// Angle in rad, 0 to π, of the rotation between two attitudes; accurate however small.
    #[must_use]
    pub fn angle_to(self, other: Self) -> f64 {
        let between = self.0.inverse() * other.0;
        2.0 * libm::atan2(between.imag().norm(), between.w.abs())
    }
}
