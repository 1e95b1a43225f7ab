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
}

impl DynamicsError {
    /// The rule broken, as the message says it.
    #[must_use]
    pub fn rule(self) -> &'static str {
        match self {
            Self::NoMass => "a force moves the body, so its mass must be given",
            Self::TwoOrbits => "gravity gradients that act at the same time must have the same mean motion",
            Self::InnerSphere => "a sphere inside the body moves by itself, which only Taylor series follow",
        }
    }
}
