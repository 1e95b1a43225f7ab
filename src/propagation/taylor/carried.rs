use nalgebra::{Quaternion, Vector3};

use super::row::Row;
use super::sums::{Instant, Sums};
use crate::body::State;

/// The state from step to step, with the digits that f64 alone would drop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Carried {
    /// s.
    pub time: Instant,
    /// World from principal axes: w, x, y, z.
    pub attitude: Sums,
    /// Principal axes, rad/s.
    pub rates: Sums,
    /// World axes, m.
    pub position: Sums,
    /// World axes, m/s.
    pub velocity: Sums,
}

impl Carried {
    /// A state at t = 0.
    pub fn new(state: &State) -> Self {
        let vector = |vector: Vector3<f64>| Sums::new(Row::from_vector(vector.into()));
        let mut carried = Self {
            time: Instant::new(0.0),
            attitude: Sums::new(Row(state.attitude.wxyz())),
            rates: vector(state.angular_velocity.in_body()),
            position: vector(state.position),
            velocity: vector(state.velocity),
        };
        carried.normalise();
        carried
    }

    /// Brings q back to unit length, by a term small enough not to cost the digits in the low part.
    #[inline(always)]
    pub fn normalise(&mut self) {
        let Sums { high, low } = self.attitude;
        let Row([ww, xx, yy, zz]) = high * (high + low + low);
        let excess = ((ww + yy) + (xx + zz)) - 1.0;
        self.attitude.add(high * Row::splat(-0.5 * excess));
    }

    /// Rᵀ w.
    pub fn to_body(self, in_world: &Vector3<f64>) -> Vector3<f64> {
        let Row([w, x, y, z]) = self.attitude.high;
        let q = Quaternion::new(w, x, y, z);
        let turned = 2.0 * q.imag().cross(in_world);
        // Divided by |q|², so that the image has the vector's length whatever rounding did to q.
        in_world + (q.imag().cross(&turned) - w * turned) / q.norm_squared()
    }

    /// Rates are given however the attitude is; a quantity not propagated stays as it was.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        let Self { attitude, rates, position, velocity, .. } = self;
        let witness = (attitude.witness() * Row::ZERO + rates.witness() * Row::ZERO)
            + (position.witness() * Row::ZERO + velocity.witness() * Row::ZERO);
        witness == Row::ZERO && self.time.high.is_finite()
    }
}
