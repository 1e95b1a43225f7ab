use nalgebra::Vector3;

use super::{Attitude, BodyError, PrincipalMoments};

fn finite(quantity: &'static str, components: [f64; 3]) -> Result<Vector3<f64>, BodyError> {
    if components.iter().all(|component| component.is_finite()) {
        Ok(Vector3::from(components))
    } else {
        Err(BodyError::NotFinite { quantity, value: components.to_vec() })
    }
}

/// Angular velocity of the body relative to the world, in body axes, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngularVelocity(Vector3<f64>);

impl AngularVelocity {
    /// From body components in rad/s.
    ///
    /// # Errors
    /// If a component is not finite.
    pub fn new(in_body: [f64; 3]) -> Result<Self, BodyError> {
        finite("angular velocity", in_body).map(Self)
    }

    /// From body components in rad/s that a formula made, unchecked.
    #[must_use]
    pub fn from_vector(in_body: Vector3<f64>) -> Self {
        Self(in_body)
    }

    /// Body components, rad/s.
    #[must_use]
    pub fn in_body(self) -> Vector3<f64> {
        self.0
    }

    /// L = I ω, where `self` is in principal axes.
    #[must_use]
    pub fn momentum(self, moments: PrincipalMoments) -> AngularMomentum {
        AngularMomentum(moments.vector().component_mul(&self.0))
    }
}

/// Angular momentum about the reference point, in body axes, N m s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngularMomentum(Vector3<f64>);

impl AngularMomentum {
    /// From body components in N m s.
    ///
    /// # Errors
    /// If a component is not finite.
    pub fn new(in_body: [f64; 3]) -> Result<Self, BodyError> {
        finite("angular momentum", in_body).map(Self)
    }

    /// Body components, N m s.
    #[must_use]
    pub fn in_body(self) -> Vector3<f64> {
        self.0
    }

    /// World components, N m s.
    #[must_use]
    pub fn in_world(self, attitude: Attitude) -> Vector3<f64> {
        attitude.to_world(&self.0)
    }

    /// ω = I⁻¹ L, where `self` is in principal axes.
    #[must_use]
    pub fn velocity(self, moments: PrincipalMoments) -> AngularVelocity {
        AngularVelocity(self.0.component_div(&moments.vector()))
    }
}

/// Moment of force (torque) about the reference point, in body axes, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment(Vector3<f64>);

impl Moment {
    /// From body components in N m.
    ///
    /// # Errors
    /// If a component is not finite.
    pub fn new(in_body: [f64; 3]) -> Result<Self, BodyError> {
        finite("moment", in_body).map(Self)
    }

    /// From body components that a formula made, unchecked.
    #[must_use]
    pub fn from_vector(in_body: Vector3<f64>) -> Self {
        Self(in_body)
    }

    /// Body components, N m.
    #[must_use]
    pub fn in_body(self) -> Vector3<f64> {
        self.0
    }
}
