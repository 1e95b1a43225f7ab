use nalgebra::Vector3;

use super::stiffness::Stiffness;
use crate::body::{MassProperties, ParticleCloud};
use crate::dynamics::DynamicsError;

/// What joins the particles of a cloud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// k of the spring between each pair, N/m, positive.
    pub stiffness: f64,
    /// c of the damper beside it, along the line between the two, N s/m, not negative.
    pub damping: f64,
    /// Whether the springs start stretched as far as the spin stretches them, and not at their lengths without force.
    pub is_relaxed: bool,
}

/// Point masses with a spring and a damper between every pair.
///
/// On the particle i acts Fᵢ = Σⱼ (k (ℓ − ℓ₀) + c dℓ/dt) n, n the direction to particle j, ℓ the distance to it and ℓ₀
/// that in the body. The forces of a pair are opposite and on one line: they cancel in Σ F and in Σ x × F.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringCloud {
    masses: Vec<f64>,
    places: Vec<Vector3<f64>>,
    springs: Springs,
    frequencies: [f64; 2],
}

impl SpringCloud {
    /// Particles at most: of these every pair is joined.
    pub const MOST_PARTICLES: usize = 16;
    /// The lowest natural frequency is above this part of the highest, or the springs do not hold the cloud in shape.
    const SLACK: f64 = 1e-6;

    /// From particles, the properties that follow from them, and what joins them.
    ///
    /// # Errors
    /// If there are too many particles, or four or more lie in one plane: springs in it do not hold them there.
    pub fn new(cloud: &ParticleCloud, body: &MassProperties, springs: Springs) -> Result<Self, DynamicsError> {
        let particles = cloud.particles();
        if particles.len() > Self::MOST_PARTICLES {
            return Err(DynamicsError::ManyParticles);
        }
        let place = |position| body.body_from_principal.inverse_transform_vector(&(position - body.about));
        let masses: Vec<f64> = particles.iter().map(|particle| particle.mass).collect();
        let places: Vec<_> = particles.iter().map(|particle| place(particle.position)).collect();
        let frequencies = Stiffness::new(&masses, &places, springs.stiffness).frequencies();
        let [lowest, highest] = frequencies;
        // Written so that NaN is refused too.
        if lowest > Self::SLACK * highest {
            return Ok(Self { masses, places, springs, frequencies });
        }
        Err(DynamicsError::SlackParticles)
    }

    /// kg, in the order of the particles.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// pᵢ: where the springs are without force, from the centre of mass, principal axes, m.
    #[must_use]
    pub fn places(&self) -> &[Vector3<f64>] {
        &self.places
    }

    /// What joins them.
    #[must_use]
    pub fn springs(&self) -> Springs {
        self.springs
    }

    /// The lowest and the highest natural frequency of the cloud, undamped and at rest, rad/s.
    #[must_use]
    pub fn natural_frequencies(&self) -> [f64; 2] {
        self.frequencies
    }

    /// The two particles of each spring: of the first particle with all others, of the second with those after it, and so on.
    pub fn pairs(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        let count = self.masses.len();
        (0..count).flat_map(move |first| (first + 1..count).map(move |second| [first, second]))
    }

    /// How far the springs are stretched by a spin `omega`, ω, that changes at `acceleration`, ω̇: to first order, where
    /// their forces are those that hold each particle on its path in a rigid body. From the places, principal axes, m.
    #[must_use]
    pub fn stretched(&self, omega: &Vector3<f64>, acceleration: &Vector3<f64>) -> Vec<Vector3<f64>> {
        let pulled = |(mass, place): (&f64, &Vector3<f64>)| {
            -*mass * (omega.cross(&omega.cross(place)) + acceleration.cross(place))
        };
        let forces: Vec<_> = self.masses.iter().zip(&self.places).map(pulled).collect();
        Stiffness::new(&self.masses, &self.places, self.springs.stiffness).displacements(&forces)
    }
}
