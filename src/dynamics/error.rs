use thiserror::Error;

/// Loads that do not make an equation of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// A force moves a body whose mass is unknown.
    #[error("a force moves the body, so its mass must be given")]
    NoMass,
    /// Two orbits at the same time.
    #[error("gravity gradients that act at the same time must have the same mean motion")]
    TwoOrbits,
    /// Motion inside the body, by a method that knows of none.
    #[error("a sphere inside the body moves by itself, which only Taylor series follow")]
    InnerSphere,
    /// Particles on springs, by a method that knows of none.
    #[error("particles on springs move by themselves, which only Taylor series follow")]
    Particles,
    /// More particles on springs than are propagated.
    #[error("springs join at most 16 particles, every two of them")]
    ManyParticles,
    /// A cloud that springs do not keep in shape.
    #[error("springs do not hold these particles in shape: four or more in one plane leave it without a force")]
    SlackParticles,
    /// Particles on springs under something else.
    #[error("nothing but uniform gravity acts on particles on springs")]
    LoadedParticles,
}

impl DynamicsError {
    /// The rule broken, as the message says it.
    #[must_use]
    pub fn rule(self) -> &'static str {
        match self {
            Self::NoMass => "a force moves the body, so its mass must be given",
            Self::TwoOrbits => "gravity gradients that act at the same time must have the same mean motion",
            Self::InnerSphere => "a sphere inside the body moves by itself, which only Taylor series follow",
            Self::Particles => "particles on springs move by themselves, which only Taylor series follow",
            Self::ManyParticles => "springs join at most 16 particles, every two of them",
            Self::SlackParticles => {
                "springs do not hold these particles in shape: four or more in one plane leave it without a force"
            }
            Self::LoadedParticles => "nothing but uniform gravity acts on particles on springs",
        }
    }
}
