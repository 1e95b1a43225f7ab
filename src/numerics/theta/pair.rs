use crate::numerics::Turn;

/// Jacobi's functions of u = 2Kv/π, v real: it grows by π, a half turn, from one flip of the body to the next.
pub trait Jacobi: Copy {
    /// What the sums need to know about v.
    type Place: Copy;

    /// Prepares the sums at v.
    fn place(&self, v: Turn) -> Self::Place;

    /// (sn u, cn u, dn u).
    fn jacobi(&self, at: Self::Place) -> [f64; 3];
}

/// θ₄ and θ₁ at v − i s for a fixed shift s, beside Jacobi's functions. Their nome is the **square** Q = e^(−2πK′/K) of
/// his.
pub trait Theta: Jacobi {
    /// θ₄(v − i s) and θ₁(v − i s), up to a positive factor common to both and a constant one of θ₁ alone: the
    /// implementation's own.
    fn pair(&self, at: Self::Place) -> ThetaPair;
}

/// Two complex numbers as [re, im], and an angle in turns by which both are still to be turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThetaPair {
    /// θ₄.
    pub a: [f64; 2],
    /// θ₁.
    pub b: [f64; 2],
    /// Common factor e^(2πi · this).
    pub turns: f64,
}
