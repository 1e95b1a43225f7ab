use nalgebra::{Matrix4, Vector4};

use super::invariants::{Polhode, Start};
use crate::numerics::{DoubleDouble, FlipSum, NomeSeries, Phase, Theta, carlson_rf, complete_k};
use crate::propagation::exact::Motion;
use crate::propagation::exact::unit;

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
    attitude_map: Matrix4<f64>,
}

/// By which nome.
#[derive(Debug, Clone, Copy)]
pub enum Nome {
    /// Far from the separatrix.
    Series(TriAxial<NomeSeries>),
    /// Near it.
    Flips(TriAxial<FlipSum>),
}

/// The periods and phases of a polhode.
struct Periods {
    k: DoubleDouble,
    k_prime: DoubleDouble,
    /// u at the start, between −K and K.
    u0: DoubleDouble,
    /// σ with sn(σ, 1 − m) where L points, with the sign of J₃ − J₁.
    shift: DoubleDouble,
}

impl Periods {
    fn new(polhode: &Polhode) -> Self {
        let Polhode { parameter: m, complement: m1, .. } = *polhode;
        let u0 = polhode.sn * carlson_rf(polhode.cn_squared, polhode.dn_squared, DoubleDouble::ONE);
        // s² = (1 − c²)/(1 − c² m₁), and what Carlson needs of it as products: 1 − s², 1 − m₁ s².
        let (c2, s2) = (polhode.cosine.square(), polhode.sine.square());
        let denominator = s2 + c2 * m;
        let sine = (s2 / denominator).sqrt();
        let integral = carlson_rf(c2 * m / denominator, m / denominator, DoubleDouble::ONE);
        let shift = sine * integral * polhode.sense;
        Self { k: complete_k(m1.sqrt()), k_prime: complete_k(m.sqrt()), u0, shift }
    }
}

impl Nome {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, polhode: &Polhode, scale: f64) -> Self {
        let periods = Periods::new(polhode);
        let Periods { k, k_prime, shift, .. } = periods;
        // At K' = K/2 both nomes are e^(-π).
        if k_prime.hi() > 0.5 * k.hi() {
            let nome = (-(DoubleDouble::PI * k_prime / k).scale(2.0)).exp();
            let theta = NomeSeries::new(nome, (DoubleDouble::PI * shift / k).scale(0.5));
            let constants = (theta.log_derivative(), theta.ratio_at_zero());
            Self::Series(TriAxial::new(start, polhode, &periods, scale, (theta, constants)))
        } else {
            let theta = FlipSum::new((k / k_prime).scale(0.5), (shift / k_prime).scale(0.5));
            let constants = (theta.log_derivative(), theta.ratio_at_zero());
            Self::Flips(TriAxial::new(start, polhode, &periods, scale, (theta, constants)))
        }
    }
}

impl<T: Theta> TriAxial<T> {
    fn new(
        start: &Start,
        polhode: &Polhode,
        periods: &Periods,
        scale: f64,
        (theta, (log_derivative, ratio_at_zero)): (T, (DoubleDouble, DoubleDouble)),
    ) -> Self {
        // v = πu/2K, which is u/4K turns.
        let turns_per_u = periods.k.scale(4.0).recip();
        let argument_rate = polhode.rate * turns_per_u;
        let argument = Phase { start: periods.u0 * turns_per_u, rate: argument_rate.scale(1.0 / scale) };
        let secular_rate = polhode.half_rate / DoubleDouble::PI.scale(2.0) - argument_rate * log_derivative;
        let secular = Phase { start: DoubleDouble::ZERO, rate: secular_rate.scale(1.0 / scale) };
        // tan(θ/2) where L is nearest to 1', over |b/a| there.
        let half_tangent = polhode.sine / (DoubleDouble::ONE + polhode.cosine);
        let zeta = (half_tangent * ratio_at_zero).hi() * polhode.sense;
        let rates = [0, 1, 2].map(|k| {
            let (axis, sign) = start.frame.destinations()[k];
            (axis, sign * polhode.amplitudes[k].hi() / scale)
        });
        let mut this = Self { theta, argument, secular, zeta, rates, attitude_map: Matrix4::zeros() };
        let [a_re, _, _, a_im] = this.pair(this.theta.place(this.argument.at(0.0)), 0.0).into();
        this.attitude_map = start.attitude_map(start.momentum_frame_from_primed([a_re, a_im]));
        this
    }

    /// w, x, y, z of "momentum frame from primed axes" at a time, not normalised.
    #[inline]
    fn pair(&self, at: T::Place, t: f64) -> Vector4<f64> {
        let pair = self.theta.pair(at);
        let (sin, cos) = self.secular.at(t).plus(pair.turns).sin_cos();
        let ([a_re, a_im], [b_re, b_im]) = (pair.a, pair.b.map(|part| self.zeta * part));
        Vector4::new(a_re * cos - a_im * sin, b_re * cos - b_im * sin, b_im * cos + b_re * sin, a_im * cos + a_re * sin)
    }

    #[inline]
    fn rates_at(&self, at: T::Place) -> [f64; 3] {
        let ([sn, cn, dn], [(_, w10), (_, w20), (_, w30)]) = (self.theta.jacobi(at), self.rates);
        [w10 * cn, w20 * sn, w30 * dn]
    }
}

impl<T: Theta> Motion for TriAxial<T> {
    fn axes(&self) -> [usize; 3] {
        self.rates.map(|(axis, _)| axis)
    }

    #[inline]
    fn rates(&self, time: f64) -> [f64; 3] {
        self.rates_at(self.theta.place(self.argument.at(time)))
    }

    #[inline]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let at = self.theta.place(self.argument.at(time));
        (self.rates_at(at), unit(self.attitude_map * self.pair(at, time)))
    }
}
