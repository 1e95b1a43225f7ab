use super::invariants::{Polhode, Start};
use super::polhode_rates::{Periods, PolhodeRates};
use crate::numerics::{DoubleDouble, FlipSum, NomeSeries, Phase, Theta, carlson_rf};
use crate::propagation::exact::{Motion, QuaternionMap, Rates};

/// Three different moments, off the separatrix: ω by Jacobi's functions, the attitude by two theta functions.
///
/// The attitude from primed axes to the frame of L is the pair a = w + iz ∝ θ₄(v − i s) e^(iμt) and
/// b = x + iy ∝ ζ θ₁(v − i s) e^(iμt), normalised: s is where L points along 3′, and the secular rate μ needs the
/// logarithmic derivative of θ₄ at i s only, no integral of the third kind.
#[derive(Debug, Clone, Copy)]
pub struct TriAxial<T> {
    rates: PolhodeRates<T>,
    /// μ t.
    secular: Phase,
    zeta: f64,
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

/// σ, with the sign of J₃ − J₁.
fn shift(polhode: &Polhode) -> DoubleDouble {
    let [sine_squared, cosine_squared, delta_squared] = polhode.shift;
    sine_squared.sqrt() * carlson_rf(cosine_squared, delta_squared, DoubleDouble::ONE) * polhode.sense
}

impl Nome {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, polhode: &Polhode, scale: f64) -> Self {
        let shift = shift(polhode);
        match Periods::new(polhode) {
            Periods::Far { nome, k } => {
                let theta = NomeSeries::new(nome, DoubleDouble::PI.scale(0.5) * shift / k);
                let rates = PolhodeRates::new(start, polhode, k, scale, theta);
                let constants = (theta.log_derivative(), theta.ratio_at_zero());
                Self::Series(TriAxial::new(start, polhode, scale, rates, constants))
            }
            Periods::Near { nome, k, over_k_prime } => {
                let theta = FlipSum::new(nome, (k * over_k_prime).scale(0.5), (shift * over_k_prime).scale(0.5));
                let rates = PolhodeRates::new(start, polhode, k, scale, theta);
                let constants = (theta.log_derivative(), theta.ratio_at_zero());
                Self::Flips(TriAxial::new(start, polhode, scale, rates, constants))
            }
        }
    }
}

impl<T: Theta> TriAxial<T> {
    fn new(
        start: &Start,
        polhode: &Polhode,
        scale: f64,
        rates: PolhodeRates<T>,
        (log_derivative, ratio_at_zero): (DoubleDouble, DoubleDouble),
    ) -> Self {
        let per_second = polhode.half_rate * DoubleDouble::TURNS_PER_RADIAN;
        let secular_rate = per_second.scale(1.0 / scale) - rates.argument.rate * log_derivative;
        // tan(θ/2) where L is nearest to 1', over |b/a| there.
        let zeta = (polhode.half_tangent * ratio_at_zero).hi() * polhode.sense;
        let secular = Phase { start: DoubleDouble::ZERO, rate: secular_rate };
        let mut this = Self { rates, secular, zeta, attitude_map: QuaternionMap::ZERO };
        let [a_re, _, _, a_im] = this.pair(this.rates.place(0.0), 0.0);
        let at_start = start.momentum_frame_from_primed(polhode.momentum_size, [a_re, a_im]);
        this.attitude_map = start.attitude_map(at_start);
        this
    }

    /// w, x, y, z of "momentum frame from primed axes" at a time, not normalised.
    #[inline(always)]
    fn pair(&self, at: T::Place, t: f64) -> [f64; 4] {
        let pair = self.rates.jacobi.pair(at);
        let (sin, cos) = self.secular.at(t).plus(pair.turns).sin_cos();
        let ([a_re, a_im], [b_re, b_im]) = (pair.a, [self.zeta * pair.b[0], self.zeta * pair.b[1]]);
        [a_re * cos - a_im * sin, b_re * cos - b_im * sin, b_im * cos + b_re * sin, a_im * cos + a_re * sin]
    }
}

impl<T: Theta> Rates for TriAxial<T> {
    #[inline(always)]
    fn axes(&self) -> [usize; 3] {
        self.rates.axes()
    }

    #[inline(always)]
    fn rates(&self, time: f64) -> [f64; 3] {
        self.rates.rates(time)
    }
}

impl<T: Theta> Motion for TriAxial<T> {
    #[inline(always)]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let at = self.rates.place(time);
        (self.rates.at(at), self.attitude_map.unit(self.pair(at, time)))
    }
}
