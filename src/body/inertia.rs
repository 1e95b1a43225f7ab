use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::error::{finite, positive};
use super::principal_axes::principal_axes;
use super::{BodyError, MassProperties, PrincipalMoments};

/// How far the halves of a tensor may differ, relative to its largest element: a few roundings.
const SYMMETRY_ROUNDING: f64 = 16.0 * f64::EPSILON;

impl MassProperties {
    /// A body given by its principal moments in kg m², about its centre of mass, which is the origin of body axes.
    ///
    /// # Errors
    /// If the mass is not positive, or no body has these moments.
    pub fn from_principal(mass: Option<f64>, moments: [f64; 3]) -> Result<Self, BodyError> {
        checked_mass(mass)?;
        Ok(Self {
            mass,
            centre_of_mass: Vector3::zeros(),
            moments: PrincipalMoments::new(moments)?,
            body_from_principal: UnitQuaternion::identity(),
            about: Vector3::zeros(),
        })
    }

    /// A body given by its inertia tensor in kg m², body axes, about its centre of mass, which is their origin.
    ///
    /// Products of inertia have the sign of the matrix: `tensor[(0, 1)]` is −∫ x y dm. A diagonal tensor keeps its axes
    /// exactly; another is turned to principal axes by the smallest rotation that does so.
    ///
    /// # Errors
    /// If the mass is not positive, the tensor not finite or not symmetric, or no body has its principal moments.
    pub fn from_tensor(mass: Option<f64>, tensor: Matrix3<f64>) -> Result<Self, BodyError> {
        checked_mass(mass)?;
        let (moments, body_from_principal) = principal_axes(&symmetric(&tensor)?);
        Ok(Self {
            mass,
            centre_of_mass: Vector3::zeros(),
            moments: PrincipalMoments::new(moments.into())?,
            body_from_principal,
            about: Vector3::zeros(),
        })
    }

    /// The same body with its moments about another point, `point` from the body's origin, body axes, m.
    ///
    /// # Errors
    /// If the point is another than [`Self::about`] and the mass is unknown, or the result is no body: moments said
    /// to be about a pivot may be too small for the distance of the centre of mass from it.
    pub fn about(&self, point: Vector3<f64>) -> Result<Self, BodyError> {
        let point = finite("point of the moments", point)?;
        if point == self.about {
            return Ok(self.clone());
        }
        let mass = self.mass.ok_or_else(|| BodyError::MassUnknown { point: point.into(), about: self.about.into() })?;
        let there = point_inertia(&(point - self.centre_of_mass));
        let here = point_inertia(&(self.about - self.centre_of_mass));
        let tensor = self.tensor() + (there - here) * mass;
        let moved = Self::from_tensor(self.mass, tensor)?;
        Ok(Self { centre_of_mass: self.centre_of_mass, about: point, ..moved })
    }

    /// The same moments about the same point, with the centre of mass elsewhere: a top, whose moments are about its
    /// pivot. `centre` from the body's origin, body axes, m.
    ///
    /// # Errors
    /// If the centre is not finite, or is so far from the point of the moments that, with this mass, the moments about
    /// the centre would be no body's.
    pub fn with_centre_of_mass(self, centre: Vector3<f64>) -> Result<Self, BodyError> {
        let body = Self { centre_of_mass: finite("centre of mass", centre)?, ..self };
        if body.mass.is_some() {
            body.about(centre)?;
        }
        Ok(body)
    }

    /// The same body shifted by `offset` in its axes, m: centre of mass and point of the moments move together.
    ///
    /// # Errors
    /// If the offset is not finite.
    pub fn shifted(self, offset: Vector3<f64>) -> Result<Self, BodyError> {
        let offset = finite("offset", offset)?;
        Ok(Self { centre_of_mass: self.centre_of_mass + offset, about: self.about + offset, ..self })
    }
}

/// |r|² E − r rᵀ: the inertia tensor of a unit point mass at `arm`, m².
pub(super) fn point_inertia(arm: &Vector3<f64>) -> Matrix3<f64> {
    let [x, y, z] = (*arm).into();
    Matrix3::new(y * y + z * z, -x * y, -x * z, -x * y, x * x + z * z, -y * z, -x * z, -y * z, x * x + y * y)
}

fn checked_mass(mass: Option<f64>) -> Result<(), BodyError> {
    mass.map_or(Ok(()), |mass| positive("mass", mass, "kg").map(drop))
}

/// The mean of both halves of a tensor that is symmetric to rounding.
fn symmetric(tensor: &Matrix3<f64>) -> Result<Matrix3<f64>, BodyError> {
    if tensor.iter().any(|element| !element.is_finite()) {
        return Err(BodyError::NotFinite { quantity: "inertia tensor", value: tensor.as_slice().to_vec() });
    }
    let room = SYMMETRY_ROUNDING * tensor.amax();
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let (upper, lower) = (tensor[(row, column)], tensor[(column, row)]);
        if (upper - lower).abs() > room {
            return Err(BodyError::NotSymmetric { row, column, upper, lower });
        }
    }
    Ok(tensor.zip_map(&tensor.transpose(), |a, b| 0.5 * a + 0.5 * b))
}
