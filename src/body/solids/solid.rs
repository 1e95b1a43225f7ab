use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::Shape;
use crate::body::assembly::{Piece, assemble};
use crate::body::error::{finite, positive};
use crate::body::{BodyError, MassProperties};

/// A shape of uniform density, placed in body axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    /// In its own axes.
    pub shape: Shape,
    /// kg/m³; negative for a hole in the solids it lies in.
    pub density: f64,
    /// Of the shape's origin, from the body's, in body axes, m.
    pub position: Vector3<f64>,
    /// Turns the shape's axes into body axes.
    pub body_from_shape: UnitQuaternion<f64>,
}

impl Solid {
    /// The shape at the body's origin, axes along the body's, of this density in kg/m³ (negative for a hole).
    ///
    /// # Errors
    /// If a length of the shape is not positive, or the density is zero or not finite.
    pub fn new(shape: Shape, density: f64) -> Result<Self, BodyError> {
        let solid = Self { shape, density, position: Vector3::zeros(), body_from_shape: UnitQuaternion::identity() };
        solid.check().map(|()| solid)
    }

    /// As [`Solid::new`], from the mass in kg.
    ///
    /// # Errors
    /// If a length of the shape or the mass is not positive.
    pub fn from_mass(shape: Shape, mass: f64) -> Result<Self, BodyError> {
        shape.check()?;
        Self::new(shape, positive("mass of a solid", mass, "kg")? / shape.volume())
    }

    /// The same with the shape's origin at `position`, body axes, m.
    #[must_use]
    pub fn at(self, position: Vector3<f64>) -> Self {
        Self { position, ..self }
    }

    /// The same with the shape turned by `body_from_shape` about its origin.
    #[must_use]
    pub fn turned(self, body_from_shape: UnitQuaternion<f64>) -> Self {
        Self { body_from_shape, ..self }
    }

    /// kg; negative for a hole.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.density * self.shape.volume()
    }

    /// Whether a hole rather than a body.
    #[must_use]
    pub fn is_hole(&self) -> bool {
        self.density < 0.0
    }

    /// Centre of mass from the body's origin, body axes, m.
    #[must_use]
    pub fn centre_of_mass(&self) -> Vector3<f64> {
        self.position + self.body_from_shape * self.shape.centre_of_mass()
    }

    fn check(&self) -> Result<(), BodyError> {
        self.shape.check()?;
        if !self.density.is_finite() || self.density == 0.0 {
            return Err(BodyError::Density(self.density));
        }
        finite("position of a solid", self.position)?;
        finite("rotation of a solid", self.body_from_shape.imag()).map(drop)
    }

    fn piece(&self) -> Piece {
        let own_axes = Matrix3::from_diagonal(&(self.shape.mean_squares() * self.mass()));
        // Not turned when there is no turn: a diagonal stays exactly diagonal.
        let second_moment = if self.body_from_shape == UnitQuaternion::identity() {
            own_axes
        } else {
            let rotation = self.body_from_shape.to_rotation_matrix();
            rotation * own_axes * rotation.inverse()
        };
        Piece { mass: self.mass(), centre: self.centre_of_mass(), second_moment }
    }
}

/// The mass properties of all `solids` together, about their common centre of mass, by parallel axes.
///
/// Where two solids overlap their densities add; a hole takes away what it is cut from.
///
/// ```
/// use nalgebra::Vector3;
/// use polhode::body::{Shape, Solid, mass_properties_of};
///
/// let ball = Solid::from_mass(Shape::Sphere { radius: 0.05 }, 2.0)?;
/// let dumbbell = [ball.at(Vector3::x() * 0.25), ball.at(Vector3::x() * -0.25)];
/// let moments = mass_properties_of(&dumbbell)?.moments.vector();
/// assert!((moments.x - 4.0 * 0.4 * 0.05 * 0.05).abs() < 1e-16);
/// assert!((moments.y - moments.x - 4.0 * 0.25 * 0.25).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
///
/// # Errors
/// If there is none, one is not valid, the total mass is not positive, or holes take more than there is.
pub fn mass_properties_of(solids: &[Solid]) -> Result<MassProperties, BodyError> {
    if solids.is_empty() {
        return Err(BodyError::Empty("solids"));
    }
    solids.iter().try_for_each(Solid::check)?;
    let pieces: Vec<Piece> = solids.iter().map(Solid::piece).collect();
    assemble(&pieces)
}
