use super::invariants::{Polhode, Start};
use crate::numerics::{DoubleDouble, Phase, carlson_rf, exp_of_negative};
use crate::propagation::exact::{Motion, QuaternionMap, Rates};

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
    attitude_map: QuaternionMap<4>,
}

impl Separatrix {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, polhode: &Polhode, scale: f64) -> Self {
        let u0 = polhode.sn * carlson_rf(polhode.cn_squared, polhode.dn_squared, DoubleDouble::ONE);
        let half_tangent = polhode.half_tangent * polhode.sense;
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
                rate: (secular_rate * DoubleDouble::TURNS_PER_RADIAN).scale(1.0 / scale),
            },
            direction: [cos.hi(), (cos * half_tangent).hi()],
            sense: polhode.sense,
            rates,
            attitude_map: QuaternionMap::ZERO,
        };
        let [a_re, _, _, a_im] = this.pair(this.place(0.0), 0.0);
        let at_start = start.momentum_frame_from_primed(polhode.momentum_size, [a_re, a_im]);
        this.attitude_map = start.attitude_map(at_start);
        this
    }

    /// x = e^(−|u|) and the sign of u.
    #[inline(always)]
    fn place(&self, time: f64) -> [f64; 2] {
        let u = (self.u0 + self.rate * time).hi();
        [exp_of_negative(-u.abs()), if u < 0.0 { -1.0 } else { 1.0 }]
    }

    /// w, x, y, z of "momentum frame from primed axes", not normalised.
    #[inline(always)]
    fn pair(&self, [x, side]: [f64; 2], t: f64) -> [f64; 4] {
        let [cos, sin] = self.direction;
        let (a_re, a_im) = ((1.0 + x) * cos, -side * (1.0 - x) * sin);
        let (b_re, b_im) = (self.sense * side * (1.0 - x) * cos, -self.sense * (1.0 + x) * sin);
        let (sin, cos) = self.secular.at(t).sin_cos();
        [a_re * cos - a_im * sin, b_re * cos - b_im * sin, b_im * cos + b_re * sin, a_im * cos + a_re * sin]
    }

    #[inline(always)]
    fn rates_at(&self, [x, side]: [f64; 2]) -> [f64; 3] {
        let [(_, w10), (_, w20), (_, w30)] = self.rates;
        let over_cosh = 1.0 / (1.0 + x * x);
        let (sech, tanh) = (2.0 * x * over_cosh, side * ((1.0 - x) * (1.0 + x)) * over_cosh);
        [w10 * sech, w20 * tanh, w30 * sech]
    }
}

impl Rates for Separatrix {
    #[inline(always)]
    fn axes(&self) -> [usize; 3] {
        [self.rates[0].0, self.rates[1].0, self.rates[2].0]
    }

    #[inline(always)]
    fn rates(&self, time: f64) -> [f64; 3] {
        self.rates_at(self.place(time))
    }
}

impl Motion for Separatrix {
    #[inline(always)]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let at = self.place(time);
        (self.rates_at(at), self.attitude_map.unit(self.pair(at, time)))
    }
}
