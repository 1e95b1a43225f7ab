use super::nutation::{Form, Nutation};
use super::start::{Start, square};
use crate::numerics::{DoubleDouble, ShiftedPair};

/// The tilt stays: regular precession, a sleeping top, a body that hangs.
#[derive(Debug, Clone, Copy)]
pub struct Steady {
    /// |A| and |B|.
    sizes: [f64; 2],
}

impl Steady {
    pub fn form(start: &Start) -> Form<Self> {
        let [a2, b2] = start.pair.map(square);
        let (upright, zero) = (start.upright_rate(), DoubleDouble::ZERO);
        // (b ± a)/(1 ± u)/2; where the axis is upright or hangs, one of A and B is 0 and its rate of no account.
        let part = |share: DoubleDouble, sign: f64| {
            let rate = upright + (start.spin * share).scale(2.0 * sign);
            if share.is_zero() { zero } else { (rate / share).scale(0.25) }
        };
        Form {
            nutation: Steady { sizes: [a2.sqrt().hi(), b2.sqrt().hi()] },
            rates: [start.half_excess + part(a2, 1.0), part(b2, -1.0) - start.half_excess],
            zeta: DoubleDouble::ONE,
            slope_rate: zero,
        }
    }
}

impl Nutation for Steady {
    #[inline(always)]
    fn at(&self, _: f64) -> ShiftedPair {
        let (first, second) = ([self.sizes[0], 0.0], [self.sizes[1], 0.0]);
        ShiftedPair { first, first_slope: [0.0; 2], second, second_slope: [0.0; 2], turns: [0.0; 2] }
    }
}
