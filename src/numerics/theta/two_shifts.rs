use crate::numerics::Turn;

/// θ₁(v − i s) and θ₂(v − i s′) of one nome for a real v and two fixed shifts, with their slopes.
///
/// 1 + u and 1 − u of a quantity u that oscillates as sn² have squares of such moduli: two complex numbers that turn
/// and swing. The nome is Jacobi's own, q = e^(−πK′/K), and v = πu/2K.
pub trait TwoShifts: Copy {
    /// Both at v, up to a positive factor common to both.
    fn pair(&self, v: Turn) -> ShiftedPair;
}

/// Two complex numbers as [re, im], each with an angle by which it is still to be turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShiftedPair {
    /// θ₁(v − i s).
    pub first: [f64; 2],
    /// d/dv of it, the common factor left out.
    pub first_slope: [f64; 2],
    /// θ₂(v − i s′).
    pub second: [f64; 2],
    /// d/dv of it, the common factor left out.
    pub second_slope: [f64; 2],
    /// Turns of each that are not yet in the numbers above.
    pub turns: [f64; 2],
}
