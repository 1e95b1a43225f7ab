use super::{ShiftedPair, TwoShifts};
use crate::numerics::{DoubleDouble, Turn, exp_of_negative};

/// Sums of Gaussians, for K′ ≤ K: the same functions in the **other** nome p = e^(−πK/K′) ≤ 0.044. `[DLMF]` 20.7(viii).
///
/// With T = K′/K and κ = 2s/πT, θ₁(v − i s) is the sum of (−1)ⁿ exp(−d²/πT + iκd), d = v − (n + ½)π, up to a factor, and
/// θ₂ the same with d = v − nπ.
#[derive(Debug, Clone, Copy)]
pub struct ShiftedFlips {
    /// −2π/T: the exponent of √x = e^(−|v|/T) for v in turns.
    decay: f64,
    /// 2/T.
    slope: f64,
    /// p.
    nome: f64,
    kappas: [f64; 2],
    /// (cos, sin) (n + ½)κπ, n = 0 to 3.
    first: [[f64; 2]; 4],
    /// (cos, sin) nκ′π, n = 0 to 3.
    second: [[f64; 2]; 4],
    log_derivatives: [DoubleDouble; 2],
    ratio: DoubleDouble,
}

/// Terms of the constants, in double-double: p^(n²) is below 1e-48 at n = 6.
const EXACT_TERMS: usize = 6;

/// Cosines and sines of nα, or of (n + ½)α, n = 0 to 5, α = κπ.
fn directions(kappa: DoubleDouble, from_half: bool) -> [[DoubleDouble; 2]; EXACT_TERMS] {
    let twice = |[c, s]: [DoubleDouble; 2]| [(c + s) * (c - s), (s * c).scale(2.0)];
    let (sin, cos) = (DoubleDouble::PI * kappa).scale(0.25).sin_cos();
    let half = twice([cos, sin]);
    let [c, s] = twice(half);
    let mut at = [if from_half { half } else { [DoubleDouble::ONE, DoubleDouble::ZERO] }; EXACT_TERMS];
    for n in 1..EXACT_TERMS {
        let [cos, sin] = at[n - 1];
        at[n] = [cos * c - sin * s, sin * c + cos * s];
    }
    at
}

/// d/ds ln θ₂(i s), and θ₂(i s) in the units of the sums.
fn constants(nome: DoubleDouble, kappa: DoubleDouble, inverse_width: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let (mut sum, mut slope) = (DoubleDouble::ONE, DoubleDouble::ZERO);
    let (mut power, mut step, mut order) = (-nome, -(nome.square() * nome), 1.0);
    for [cos, sin] in &directions(kappa, false)[1..] {
        sum += (*cos * power).scale(2.0);
        slope += *sin * power * order;
        (power, step, order) = (power * step, step * nome.square(), order + 1.0);
    }
    (kappa - (slope * inverse_width).scale(4.0) / sum, sum)
}

impl ShiftedFlips {
    /// From p = e^(−π/T), 1/T = K/K′ (at least 1), and both κ, between −1 and 1.
    #[must_use]
    pub fn new(nome: DoubleDouble, inverse_width: DoubleDouble, kappas: [DoubleDouble; 2]) -> Self {
        let (first_slope, first_size) = constants(nome, kappas[0], inverse_width);
        let (second_slope, second_size) = constants(nome, kappas[1], inverse_width);
        // θ₂/θ₃ at 0 in the other nome, without the p^(1/4) that the pair leaves out.
        let (mut theta_2, mut theta_3) = (DoubleDouble::ONE, DoubleDouble::ONE);
        let (mut oblong, mut square, mut step) = (nome.square(), nome.scale(2.0), nome.square() * nome);
        for _ in 1..EXACT_TERMS {
            theta_2 += oblong;
            theta_3 += square;
            (oblong, square, step) = (oblong * step * nome, square * step, step * nome.square());
        }
        let four = |kappa, from_half| {
            let at = directions(kappa, from_half);
            [0, 1, 2, 3].map(|n| at[n].map(DoubleDouble::hi))
        };
        Self {
            decay: (DoubleDouble::PI * inverse_width).scale(-2.0).hi(),
            slope: inverse_width.scale(2.0).hi(),
            nome: nome.hi(),
            kappas: kappas.map(DoubleDouble::hi),
            first: four(kappas[0], true),
            second: four(kappas[1], false),
            log_derivatives: [first_slope, second_slope],
            ratio: theta_2.scale(2.0) / theta_3 * (first_size / second_size),
        }
    }

    /// A slope in units of 2/T, with that of the phase κv which is still to be turned by.
    #[inline(always)]
    fn with_phase(&self, slope: [f64; 2], value: [f64; 2], kappa: f64) -> [f64; 2] {
        [self.slope * slope[0] - kappa * value[1], self.slope * slope[1] + kappa * value[0]]
    }

    /// d/ds ln θ₂(i s) at either shift.
    #[must_use]
    pub fn log_derivatives(&self) -> [DoubleDouble; 2] {
        self.log_derivatives
    }

    /// θ₄(0) θ₂(i s) / θ₃(0) θ₂(i s′), in the units of [`TwoShifts::pair`].
    #[must_use]
    pub fn ratio(&self) -> DoubleDouble {
        self.ratio
    }
}

impl TwoShifts for ShiftedFlips {
    #[inline(always)]
    fn pair(&self, v: Turn) -> ShiftedPair {
        let (taken, v) = v.without_half_turn();
        let (side, half) = (if v < 0.0 { -1.0 } else { 1.0 }, if taken { -1.0 } else { 1.0 });
        let p = self.nome;
        let root = exp_of_negative(self.decay * v.abs());
        let x = root * root;
        let y = (p / x).min(1.0);
        let (p2, x2, y2) = (p * p, x * x, y * y);
        let (p4, p6) = (p2 * p2, p2 * p2 * p2);
        // The Gaussians at v − (n + ½)π and at v + (n + ½)π, over the first of them.
        let ahead = [1.0, p * y, p4 * y2, p6 * p2 * p * y2 * y];
        let behind = [x, p2 * x2, p6 * x2 * x, p6 * p6 * x2 * x2];
        let (mut first, mut first_slope) = ([0.0; 2], [0.0; 2]);
        let (mut sign, mut order) = (-1.0, 3.0);
        for n in (0..4).rev() {
            let [cos, sin] = self.first[n];
            let (a, b) = (sign * ahead[n], sign * behind[n]);
            first = [first[0] + (a - b) * cos, first[1] - (a + b) * sin];
            let (a, b) = (order * a, (order + 1.0) * b);
            first_slope = [first_slope[0] + (a + b) * cos, first_slope[1] + (b - a) * sin];
            (sign, order) = (-sign, order - 1.0);
        }
        // And at v − nπ and v + nπ.
        let ahead = [0.5, y, p2 * y2, p6 * y2 * y];
        let behind = [0.5, p * x, p4 * x2, p6 * p2 * p * x2 * x];
        let (mut second, mut second_slope) = ([0.0; 2], [0.0; 2]);
        (sign, order) = (-1.0, 3.0);
        for n in (0..4).rev() {
            let [cos, sin] = self.second[n];
            let (a, b) = (sign * ahead[n], sign * behind[n]);
            second = [second[0] + (a + b) * cos, second[1] + (b - a) * sin];
            let (a, b) = ((order - 0.5) * a, (order + 0.5) * b);
            second_slope = [second_slope[0] + (a - b) * cos, second_slope[1] - (a + b) * sin];
            (sign, order) = (-sign, order - 1.0);
        }
        let second = [root * second[0], root * second[1]];
        let second_slope = [root * second_slope[0], root * second_slope[1]];
        // θ₁ is odd and θ₂ even in v − i s: for v < 0 both turn into conjugates, θ₁ with the other sign.
        let first_slope = self.with_phase(first_slope, first, self.kappas[0]);
        let second_slope = self.with_phase(second_slope, second, self.kappas[1]);
        ShiftedPair {
            first: [half * side * first[0], half * first[1]],
            first_slope: [half * first_slope[0], half * side * first_slope[1]],
            second: [half * second[0], half * side * second[1]],
            second_slope: [half * side * second_slope[0], half * second_slope[1]],
            turns: [self.kappas[0] * v, self.kappas[1] * v],
        }
    }
}
