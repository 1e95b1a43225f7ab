use nalgebra::{Matrix3, Vector3};

use crate::body::assembly::{Piece, assemble, centre_of_mass, compensated_sum};
use crate::body::error::finite;
use crate::body::{BodyError, MassProperties};

/// A point mass fixed in a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    /// kg, positive.
    pub mass: f64,
    /// p: from the body's origin, body axes, m.
    pub position: Vector3<f64>,
}

/// Point masses rigidly joined.
#[derive(Debug, Clone, PartialEq)]
pub struct ParticleCloud {
    particles: Vec<Particle>,
}

impl ParticleCloud {
    /// How small, relative to the largest, a moment must be to count as the rounding of a zero.
    const LINE_ROUNDING: f64 = 64.0 * f64::EPSILON;

    /// A cloud of at least one particle.
    ///
    /// # Errors
    /// If there is none, or one has a mass that is not positive or a position that is not finite.
    pub fn new(particles: Vec<Particle>) -> Result<Self, BodyError> {
        if particles.is_empty() {
            return Err(BodyError::Empty("particles"));
        }
        for (index, &Particle { mass, position }) in particles.iter().enumerate() {
            if !(mass.is_finite() && mass > 0.0) {
                return Err(BodyError::ParticleMass { index, mass });
            }
            finite("position of a particle", position)?;
        }
        Ok(Self { particles })
    }

    /// In the order given.
    #[must_use]
    pub fn particles(&self) -> &[Particle] {
        &self.particles
    }

    /// M = Σ mᵢ, kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        compensated_sum(self.particles.iter().map(|particle| particle.mass))
    }

    /// X = Σ mᵢ pᵢ / M, from the body's origin, body axes, m.
    #[must_use]
    pub fn centre_of_mass(&self) -> Vector3<f64> {
        centre_of_mass(&self.pieces(), self.mass())
    }

    /// Mass, centre of mass X = Σ mᵢ pᵢ / M, and I₀ = Σ mᵢ (|r|² E − r rᵀ) about it, r = pᵢ − X.
    ///
    /// # Errors
    /// If all particles lie on one line or in one point: there is no moment of inertia about it.
    pub fn mass_properties(&self) -> Result<MassProperties, BodyError> {
        let piece =
            |&Particle { mass, position }: &Particle| Piece { mass, centre: position, second_moment: Matrix3::zeros() };
        let pieces: Vec<Piece> = self.particles.iter().map(piece).collect();
        let body = assemble(&pieces);
        let moments = match &body {
            Ok(body) => body.moments.vector(),
            Err(BodyError::MomentNotPositive(moments)) => Vector3::from(*moments),
            Err(_) => return body,
        };
        let (smallest, largest) = (moments.min(), moments.max());
        if largest.is_finite() && smallest <= Self::LINE_ROUNDING * largest {
            return Err(BodyError::Collinear { count: self.particles.len(), smallest, largest });
        }
        body
    }

    fn pieces(&self) -> Vec<Piece> {
        let piece =
            |&Particle { mass, position }: &Particle| Piece { mass, centre: position, second_moment: Matrix3::zeros() };
        self.particles.iter().map(piece).collect()
    }
}
