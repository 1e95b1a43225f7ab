use thiserror::Error;

/// A body that cannot exist, or a quantity that cannot be what its type says.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum BodyError {
    /// A moment of inertia is not a positive finite number.
    #[error("principal moments {0:?} kg m²: each must be positive and finite")]
    MomentNotPositive([f64; 3]),
    /// One moment exceeds the sum of the other two: no mass distribution has it.
    #[error("principal moments {0:?} kg m²: the largest may not exceed the sum of the other two (triangle inequality)")]
    TriangleInequality([f64; 3]),
    /// The quaternion is not of unit length.
    #[error("attitude quaternion {quaternion:?} has length {length}: it must be 1 within {tolerance:e}")]
    NotUnit {
        /// As given: w, x, y, z.
        quaternion: [f64; 4],
        /// Its length.
        length: f64,
        /// How far from 1 the length may be.
        tolerance: f64,
    },
    /// A component is NaN or infinite.
    #[error("{quantity} {value:?}: every component must be finite")]
    NotFinite {
        /// What was given.
        quantity: &'static str,
        /// Its components.
        value: Vec<f64>,
    },
}
