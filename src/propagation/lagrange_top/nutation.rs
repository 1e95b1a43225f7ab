use super::roots::Roots;
use super::start::Start;
use crate::numerics::{
    DoubleDouble, Phase, ShiftedFlips, ShiftedPair, ShiftedSeries, TwoShifts, carlson_rf, complete_k,
    complete_k_of_nome, nome,
};

/// A and B at a time, up to a common positive factor, before they are turned evenly.
pub trait Nutation: Copy {
    /// The pair and its slopes.
    fn at(&self, time: f64) -> ShiftedPair;
}

/// What makes a motion of a nutation.
#[derive(Debug, Clone, Copy)]
pub struct Form<N> {
    pub nutation: N,
    /// At which A and B turn besides, rad/s.
    pub rates: [DoubleDouble; 2],
    /// |B/A| of the motion over that of the nutation.
    pub zeta: DoubleDouble,
    /// rad/s by which the slopes are to be multiplied.
    pub slope_rate: DoubleDouble,
}

/// A tilt that goes to and fro for ever, by theta functions.
#[derive(Debug, Clone, Copy)]
pub struct Periodic<T> {
    theta: T,
    /// v.
    argument: Phase,
}

impl<T: TwoShifts> Nutation for Periodic<T> {
    #[inline(always)]
    fn at(&self, time: f64) -> ShiftedPair {
        self.theta.pair(self.argument.at(time))
    }
}

/// By which nome.
#[derive(Debug, Clone, Copy)]
pub enum Nome {
    /// Far from the homoclinic motion.
    Series(Form<Periodic<ShiftedSeries>>),
    /// Near it.
    Flips(Form<Periodic<ShiftedFlips>>),
}

/// The sign of `of` on `size`.
pub fn signed(size: DoubleDouble, of: DoubleDouble) -> DoubleDouble {
    if of.hi() < 0.0 { -size } else { size }
}

/// What A and B turn evenly, leaving out what the theta functions turn at the same places.
pub fn even_rates(start: &Start, roots: &Roots) -> [DoubleDouble; 2] {
    [
        start.half_excess + (roots.sum / roots.from_bottom_2).scale(0.5),
        (roots.difference / roots.from_top_1).scale(0.5) - start.half_excess,
    ]
}

impl Nome {
    pub fn new(start: &Start, roots: &Roots) -> Self {
        let Roots { lower_gap, upper_gap, from_top_1, from_top_2, from_bottom_1, from_bottom_2, .. } = *roots;
        let span = lower_gap + upper_gap;
        let (one, over_span) = (DoubleDouble::ONE, span.recip());
        let (parameter, complement) = (lower_gap * over_span, upper_gap * over_span);
        // K′ > K where m < ½: the smaller nome it is.
        let in_nome = complement > parameter;
        let (nome, k) = if in_nome {
            let nome = nome(parameter, complement.sqrt());
            (nome, complete_k_of_nome(nome))
        } else {
            (nome(complement, parameter.sqrt()), complete_k(complement.sqrt()))
        };
        // u = u₁ + (u₂ − u₁) sn².
        let u0 = (roots.below / lower_gap).sqrt()
            * carlson_rf(roots.above / lower_gap, (upper_gap + roots.above) * over_span, one);
        // 1 + u is 0 where sn = i sc(σ₁, 1 − m), and 1 − u where sn = 1/dn(σ₂, 1 − m).
        let first = (from_bottom_1 / from_bottom_2).sqrt()
            * carlson_rf(lower_gap / from_bottom_2, parameter * roots.from_bottom_3 / from_bottom_2, one);
        let denominator = from_top_1 * upper_gap;
        let second = (from_top_2 * span / denominator).sqrt()
            * carlson_rf(lower_gap * roots.over_top / denominator, lower_gap / from_top_1, one);
        let shifts = [signed(first, roots.sum), signed(second, roots.difference)];
        let rate = (start.strength * span).sqrt().scale(0.5);
        let turns_per_u = k.scale(4.0).recip();
        let argument = Phase { start: signed(u0, start.slope()) * turns_per_u, rate: rate * turns_per_u };
        let slope_rate = DoubleDouble::PI.scale(2.0) * argument.rate;
        let size = (from_top_1 / from_bottom_2).sqrt();
        let even = even_rates(start, roots);
        let less = |[a, b]: [DoubleDouble; 2]| [even[0] - slope_rate * a, even[1] - slope_rate * b];
        if in_nome {
            let per_argument = DoubleDouble::PI.scale(2.0) * turns_per_u;
            let theta = ShiftedSeries::new(nome, shifts.map(|shift| shift * per_argument));
            return Self::Series(Form {
                nutation: Periodic { theta, argument },
                rates: less(theta.log_derivatives()),
                zeta: size * theta.ratio(),
                slope_rate,
            });
        }
        let over_k_prime = complete_k_of_nome(nome).recip();
        let theta = ShiftedFlips::new(nome, k * over_k_prime, shifts.map(|shift| shift * over_k_prime));
        Self::Flips(Form {
            nutation: Periodic { theta, argument },
            rates: less(theta.log_derivatives()),
            zeta: size * theta.ratio(),
            slope_rate,
        })
    }
}
