use super::invariants::{Polhode, Start};
use crate::numerics::{
    DoubleDouble, Jacobi, JacobiFlips, JacobiSeries, Phase, carlson_rf, complete_k, complete_k_of_nome, nome,
};
use crate::propagation::exact::Rates;

/// ω along a polhode off the separatrix, by Jacobi's functions: all there is to work out where nobody wants the attitude.
#[derive(Debug, Clone, Copy)]
pub struct PolhodeRates<J> {
    pub jacobi: J,
    /// v.
    pub argument: Phase,
    /// w₁₀ cn, w₂₀ sn and w₃₀ dn: where they go, and their signed amplitudes, rad/s.
    amplitudes: [(usize, f64); 3],
}

/// Nome and period.
pub enum Periods {
    /// K′ > K/2: the nome Q = e^(−2πK′/K).
    Far { nome: DoubleDouble, k: DoubleDouble },
    /// Near the separatrix: the nome P = e^(−πK/2K′), and 1/K′.
    Near { nome: DoubleDouble, k: DoubleDouble, over_k_prime: DoubleDouble },
}

/// k′ where K′ = K/2 and both nomes are e^(−π): 3 − 2√2.
const MIDDLE: f64 = 0.171_572_875_253_809_9;

impl Periods {
    pub fn new(polhode: &Polhode) -> Self {
        let (m, modulus) = (polhode.parameter, polhode.complement.sqrt());
        if modulus.hi() > MIDDLE {
            // Q is the nome of Landen's next modulus, k₁ = (1 − k′)/(1 + k′), and K = (1 + k₁) K₁.
            let over_upper = (DoubleDouble::ONE + modulus).recip();
            let k1 = m * over_upper.square();
            let nome = nome(k1.square(), (modulus.sqrt() * over_upper).scale(2.0));
            return Self::Far { nome, k: (complete_k_of_nome(nome) * over_upper).scale(2.0) };
        }
        // P is the root of the nome of the complementary modulus.
        let nome = nome(polhode.complement, m.sqrt());
        Self::Near { nome: nome.sqrt(), k: complete_k(modulus), over_k_prime: complete_k_of_nome(nome).recip() }
    }
}

/// By which nome.
#[derive(Debug, Clone, Copy)]
pub enum RatesNome {
    /// Far from the separatrix.
    Series(PolhodeRates<JacobiSeries>),
    /// Near it.
    Flips(PolhodeRates<JacobiFlips>),
}

impl RatesNome {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, polhode: &Polhode, scale: f64) -> Self {
        match Periods::new(polhode) {
            Periods::Far { nome, k } => {
                Self::Series(PolhodeRates::new(start, polhode, k, scale, JacobiSeries::new(nome)))
            }
            Periods::Near { nome, k, over_k_prime } => {
                let jacobi = JacobiFlips::new(nome, (k * over_k_prime).scale(0.5));
                Self::Flips(PolhodeRates::new(start, polhode, k, scale, jacobi))
            }
        }
    }
}

impl<J: Jacobi> PolhodeRates<J> {
    pub fn new(start: &Start, polhode: &Polhode, k: DoubleDouble, scale: f64, jacobi: J) -> Self {
        // v = πu/2K, which is u/4K turns, and u₀ between −K and K.
        let turns_per_u = k.scale(4.0).recip();
        let u0 = polhode.sn * carlson_rf(polhode.cn_squared, polhode.dn_squared, DoubleDouble::ONE);
        let argument = Phase { start: u0 * turns_per_u, rate: (polhode.rate * turns_per_u).scale(1.0 / scale) };
        let amplitudes = [0, 1, 2].map(|k| {
            let (axis, sign) = start.frame.destinations()[k];
            (axis, sign * polhode.amplitudes[k].hi() / scale)
        });
        Self { jacobi, argument, amplitudes }
    }

    #[inline(always)]
    pub fn place(&self, time: f64) -> J::Place {
        self.jacobi.place(self.argument.at(time))
    }

    #[inline(always)]
    pub fn at(&self, at: J::Place) -> [f64; 3] {
        let ([sn, cn, dn], [(_, w10), (_, w20), (_, w30)]) = (self.jacobi.jacobi(at), self.amplitudes);
        [w10 * cn, w20 * sn, w30 * dn]
    }
}

impl<J: Jacobi> Rates for PolhodeRates<J> {
    #[inline(always)]
    fn axes(&self) -> [usize; 3] {
        [self.amplitudes[0].0, self.amplitudes[1].0, self.amplitudes[2].0]
    }

    #[inline(always)]
    fn rates(&self, time: f64) -> [f64; 3] {
        self.at(self.place(time))
    }
}
