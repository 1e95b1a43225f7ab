use crate::numerics::Turn;

/// θ₄ and θ₁ at v − i s for a real argument v and a fixed shift s, and Jacobi's functions at the same place.
///
/// The nome of θ₄ and θ₁ is the **square** Q = e^(−2πK′/K) of Jacobi's, and u = 2Kv/π his argument: v grows by π, a half
/// turn, from one flip of the body to the next.
pub trait Theta: Copy {
    /// What both families of sums need to know about v.
    type Place: Copy;

    /// Prepares the sums at v.
    fn place(&self, v: Turn) -> Self::Place;

    /// (sn u, cn u, dn u).
    fn jacobi(&self, at: Self::Place) -> [f64; 3];

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
