use nalgebra::{Matrix4, Vector4};

use super::invariants::{Polhode, Start};
use crate::numerics::{DoubleDouble, Phase, carlson_rf};
use crate::propagation::exact::Motion;
use crate::propagation::exact::unit;

/// L² = 2E J₂ exactly: one flip, from the middle axis to the middle axis, for ever. sn → tanh, cn and dn → sech.
///
/// The limit of the sum over flips with two terms left: 1 ahead, x = e^(−|u|) behind, directions ± θ/2.
#[derive(Debug, Clone, Copy)]
pub struct Separatrix {
    /// u at the start, and du/dt in 1/s.
    u0: DoubleDouble,
    rate: DoubleDouble,
    /// Half-angle about L.
    secular: Phase,
    /// cos and sin of θ/2, θ from 3′ to L at u = 0, with the sign of J₃ − J₁.
    direction: [f64; 2],
    /// Sign of J₃ − J₁.
    sense: f64,
    rates: [(usize, f64); 3],
    attitude_map: Matrix4<f64>,
}

impl Separatrix {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, polhode: &Polhode, scale: f64) -> Self {
        let u0 = polhode.sn * carlson_rf(polhode.cn_squared, polhode.dn_squared, DoubleDouble::ONE);
        let half_tangent = polhode.sine / (DoubleDouble::ONE + polhode.cosine) * polhode.sense;
        let cos = (DoubleDouble::ONE + half_tangent.square()).sqrt().recip();
        let secular_rate = polhode.half_rate + (polhode.rate * half_tangent).scale(0.5);
        let rates = [0, 1, 2].map(|k| {
            let (axis, sign) = start.frame.destinations()[k];
            (axis, sign * polhode.amplitudes[k].hi() / scale)
        });
        let mut this = Self {
            u0,
            rate: polhode.rate.scale(1.0 / scale),
            secular: Phase {
                start: DoubleDouble::ZERO,
                rate: (secular_rate / DoubleDouble::PI.scale(2.0)).scale(1.0 / scale),
            },
            direction: [cos.hi(), (cos * half_tangent).hi()],
            sense: polhode.sense,
            rates,
            attitude_map: Matrix4::zeros(),
        };
        let [a_re, _, _, a_im] = this.pair(this.argument(0.0), 0.0).into();
        this.attitude_map = start.attitude_map(start.momentum_frame_from_primed([a_re, a_im]));
        this
    }

    fn argument(&self, t: f64) -> f64 {
        (self.u0 + self.rate * t).hi()
    }

    /// w, x, y, z of "momentum frame from primed axes", not normalised.
    fn pair(&self, u: f64, t: f64) -> Vector4<f64> {
        let x = libm::exp(-u.abs());
        let ([cos, sin], side) = (self.direction, u.signum());
        let (a_re, a_im) = ((1.0 + x) * cos, -side * (1.0 - x) * sin);
        let (b_re, b_im) = (self.sense * side * (1.0 - x) * cos, -self.sense * (1.0 + x) * sin);
        let (sin, cos) = self.secular.at(t).sin_cos();
        Vector4::new(a_re * cos - a_im * sin, b_re * cos - b_im * sin, b_im * cos + b_re * sin, a_im * cos + a_re * sin)
    }

    fn rates_at(&self, u: f64) -> [f64; 3] {
        let [(_, w10), (_, w20), (_, w30)] = self.rates;
        let x = libm::exp(-u.abs());
        let sech = 2.0 * x / (1.0 + x * x);
        [w10 * sech, w20 * libm::tanh(u), w30 * sech]
    }
}

impl Motion for Separatrix {
    fn axes(&self) -> [usize; 3] {
        self.rates.map(|(axis, _)| axis)
    }

    fn rates(&self, time: f64) -> [f64; 3] {
        self.rates_at(self.argument(time))
    }

    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let u = self.argument(time);
        (self.rates_at(u), unit(self.attitude_map * self.pair(u, time)))
    }
}
