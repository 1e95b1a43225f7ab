#![allow(clippy::inline_always, reason = "what is not inlined into `vectorised` is not vector code")]

use super::invariants::{Polhode, Start};
use crate::numerics::{
    DoubleDouble, FlipSum, NomeSeries, Phase, Theta, carlson_rf, complete_k, complete_k_of_nome, nome,
};
use crate::propagation::exact::{Motion, QuaternionMap};

/// Three different moments, off the separatrix: ω by Jacobi's functions, the attitude by two theta functions.
///
/// The attitude from primed axes to the frame of L is the pair a = w + iz ∝ θ₄(v − i s) e^(iμt) and
/// b = x + iy ∝ ζ θ₁(v − i s) e^(iμt), normalised: s is where L points along 3′, and the secular rate μ needs the
/// logarithmic derivative of θ₄ at i s only, no integral of the third kind.
#[derive(Debug, Clone, Copy)]
pub struct TriAxial<T> {
    theta: T,
    /// v.
    argument: Phase,
    /// μ t.
    secular: Phase,
    zeta: f64,
    /// w₁₀ cn, w₂₀ sn and w₃₀ dn: where they go, and their signed amplitudes, rad/s.
    rates: [(usize, f64); 3],
    attitude_map: QuaternionMap<4>,
}

/// By which nome.
#[derive(Debug, Clone, Copy)]
pub enum Nome {
    /// Far from the separatrix.
    Series(TriAxial<NomeSeries>),
    /// Near it.
    Flips(TriAxial<FlipSum>),
}

/// k′ where K′ = K/2 and both nomes are e^(−π): 3 − 2√2.
const MIDDLE: f64 = 0.171_572_875_253_809_9;

/// σ, with the sign of J₃ − J₁.
fn shift(polhode: &Polhode) -> DoubleDouble {
    let [sine_squared, cosine_squared, delta_squared] = polhode.shift;
    sine_squared.sqrt() * carlson_rf(cosine_squared, delta_squared, DoubleDouble::ONE) * polhode.sense
}

impl Nome {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, polhode: &Polhode, scale: f64) -> Self {
        let (one, half_pi) = (DoubleDouble::ONE, DoubleDouble::PI.scale(0.5));
        let (m, k_prime_modulus) = (polhode.parameter, polhode.complement.sqrt());
        if k_prime_modulus.hi() > MIDDLE {
            // The squared nome is that of Landen's next modulus, k₁ = (1 − k′)/(1 + k′), and K = (1 + k₁) K₁.
            let upper = one + k_prime_modulus;
            let over_upper = upper.recip();
            let k1 = m * over_upper.square();
            let nome = nome(k1.square(), (k_prime_modulus.sqrt() * over_upper).scale(2.0));
            let k = (complete_k_of_nome(nome) * over_upper).scale(2.0);
            let theta = NomeSeries::new(nome, half_pi * shift(polhode) / k);
            let constants = (theta.log_derivative(), theta.ratio_at_zero());
            Self::Series(TriAxial::new(start, polhode, k, scale, (theta, constants)))
        } else {
            let k = complete_k(k_prime_modulus);
            let nome = nome(polhode.complement, m.sqrt());
            let over_k_prime = complete_k_of_nome(nome).recip();
            let theta =
                FlipSum::new(nome.sqrt(), (k * over_k_prime).scale(0.5), (shift(polhode) * over_k_prime).scale(0.5));
            let constants = (theta.log_derivative(), theta.ratio_at_zero());
            Self::Flips(TriAxial::new(start, polhode, k, scale, (theta, constants)))
        }
    }
}

impl<T: Theta> TriAxial<T> {
    fn new(
        start: &Start,
        polhode: &Polhode,
        k: DoubleDouble,
        scale: f64,
        (theta, (log_derivative, ratio_at_zero)): (T, (DoubleDouble, DoubleDouble)),
    ) -> Self {
        // v = πu/2K, which is u/4K turns, and u₀ between −K and K.
        let turns_per_u = k.scale(4.0).recip();
        let argument_rate = polhode.rate * turns_per_u;
        let u0 = polhode.sn * carlson_rf(polhode.cn_squared, polhode.dn_squared, DoubleDouble::ONE);
        let argument = Phase { start: u0 * turns_per_u, rate: argument_rate.scale(1.0 / scale) };
        let secular_rate = polhode.half_rate * DoubleDouble::TURNS_PER_RADIAN - argument_rate * log_derivative;
        let secular = Phase { start: DoubleDouble::ZERO, rate: secular_rate.scale(1.0 / scale) };
        // tan(θ/2) where L is nearest to 1', over |b/a| there.
        let zeta = (polhode.half_tangent * ratio_at_zero).hi() * polhode.sense;
        let rates = [0, 1, 2].map(|k| {
            let (axis, sign) = start.frame.destinations()[k];
            (axis, sign * polhode.amplitudes[k].hi() / scale)
        });
        let mut this = Self { theta, argument, secular, zeta, rates, attitude_map: QuaternionMap::ZERO };
        let [a_re, _, _, a_im] = this.pair(this.theta.place(this.argument.at(0.0)), 0.0);
        let at_start = start.momentum_frame_from_primed(polhode.momentum_size, [a_re, a_im]);
        this.attitude_map = start.attitude_map(at_start);
        this
    }

    /// w, x, y, z of "momentum frame from primed axes" at a time, not normalised.
    #[inline(always)]
    fn pair(&self, at: T::Place, t: f64) -> [f64; 4] {
        let pair = self.theta.pair(at);
        let (sin, cos) = self.secular.at(t).plus(pair.turns).sin_cos();
        let ([a_re, a_im], [b_re, b_im]) = (pair.a, [self.zeta * pair.b[0], self.zeta * pair.b[1]]);
        [a_re * cos - a_im * sin, b_re * cos - b_im * sin, b_im * cos + b_re * sin, a_im * cos + a_re * sin]
    }

    #[inline(always)]
    fn rates_at(&self, at: T::Place) -> [f64; 3] {
        let ([sn, cn, dn], [(_, w10), (_, w20), (_, w30)]) = (self.theta.jacobi(at), self.rates);
        [w10 * cn, w20 * sn, w30 * dn]
    }
}

impl<T: Theta> Motion for TriAxial<T> {
    #[inline(always)]
    fn axes(&self) -> [usize; 3] {
        [self.rates[0].0, self.rates[1].0, self.rates[2].0]
    }

    #[inline(always)]
    fn rates(&self, time: f64) -> [f64; 3] {
        self.rates_at(self.theta.place(self.argument.at(time)))
    }

    #[inline(always)]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let at = self.theta.place(self.argument.at(time));
        (self.rates_at(at), self.attitude_map.unit(self.pair(at, time)))
    }
}
