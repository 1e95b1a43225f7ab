use nalgebra::{Quaternion, Vector3};

use super::sums::Sums;
use crate::body::State;

/// The state from step to step, with the digits that f64 alone would drop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Carried {
    /// s.
    pub time: Sums<1>,
    /// World from principal axes: w, x, y, z.
    pub attitude: Sums<4>,
    /// Principal axes, rad/s.
    pub rates: Sums<3>,
    /// World axes, m.
    pub position: Sums<3>,
    /// World axes, m/s.
    pub velocity: Sums<3>,
}

impl Carried {
    /// A state at t = 0.
    pub fn new(state: &State) -> Self {
        let mut carried = Self {
            time: Sums::new([0.0]),
            attitude: Sums::new(state.attitude.wxyz()),
            rates: Sums::new(state.angular_velocity.in_body().into()),
            position: Sums::new(state.position.into()),
            velocity: Sums::new(state.velocity.into()),
        };
        carried.normalise();
        carried
    }

    /// Brings q back to unit length, by a term small enough not to cost the digits in the low part.
    pub fn normalise(&mut self) {
        let Sums { high, low } = self.attitude;
        let excess = high.iter().zip(&low).map(|(high, low)| high * (high + 2.0 * low)).sum::<f64>() - 1.0;
        self.attitude.add(high.map(|component| -0.5 * excess * component));
    }

    /// Rᵀ w.
    pub fn to_body(self, in_world: &Vector3<f64>) -> Vector3<f64> {
        let [w, x, y, z] = self.attitude.high;
        let q = Quaternion::new(w, x, y, z);
        let turned = 2.0 * q.imag().cross(in_world);
        // Divided by |q|², so that the image has the vector's length whatever rounding did to q.
        in_world + (q.imag().cross(&turned) - w * turned) / q.norm_squared()
    }

    /// Rates are given however the attitude is; a quantity not propagated stays as it was.
    pub fn is_finite(&self) -> bool {
        self.time.is_finite()
            && self.attitude.is_finite()
            && self.rates.is_finite()
            && self.position.is_finite()
            && self.velocity.is_finite()
    }
}
