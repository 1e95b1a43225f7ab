use super::{ShiftedPair, TwoShifts};
use crate::numerics::{DoubleDouble, Turn};

/// Series in the nome, for K′ ≥ K: q ≤ e^(−π) = 0.043, where four terms reach the last bit at any shift.
#[derive(Debug, Clone, Copy)]
pub struct ShiftedSeries {
    first: OneShift,
    second: OneShift,
    log_derivatives: [DoubleDouble; 2],
    ratio: DoubleDouble,
}

/// ± q^(n(n+1)) (cosh, sinh)(2n+1)s, divided by e^|s|/2.
type OneShift = [[f64; 2]; 4];

/// The coefficients, d/ds ln θ₂(i s), and θ₂(i s) in the same units.
fn one_shift(nome: DoubleDouble, shift: DoubleDouble) -> (OneShift, DoubleDouble, DoubleDouble) {
    let side = if shift.hi() < 0.0 { -1.0 } else { 1.0 };
    let growth = shift.abs().scale(2.0).exp();
    let decay = growth.recip();
    // q^(n(n+1)) e^(±(2n+1)s − s): |s| is at most half of |ln q|, so that neither grows. q^(n²) bounds them: from n = 3
    // on f64 holds what counts of them.
    let (up, down) = (nome * growth, nome * decay);
    let nome_4 = nome.square().square();
    let (q, q4) = (nome.hi(), nome_4.hi());
    let (q7, q9) = (q4 * (q * q * q), q4 * q4 * q);
    let pair = |up: DoubleDouble, down: DoubleDouble| [up + down, up - down];
    let [first, second, third] = [
        pair(DoubleDouble::ONE, decay),
        pair(up * nome, down * nome * decay),
        pair(up.square() * nome_4, down.square() * nome_4 * decay),
    ];
    let (u, d) = (up.hi(), down.hi());
    let (up_3, down_3) = (u * u * u * q9, d * d * d * q9 * decay.hi());
    let (up_4, down_4) = (up_3 * u * q7, down_3 * d * q7);
    let sum = (third[0] + (up_3 + down_3 + (up_4 + down_4)).into()) + second[0] + first[0];
    let slope = (third[1] * 5.0 + (7.0 * (up_3 - down_3) + 9.0 * (up_4 - down_4)).into()) + second[1] * 3.0 + first[1];
    let rounded = |[cosh, sinh]: [DoubleDouble; 2], sign: f64| [sign * cosh.hi(), side * sign * sinh.hi()];
    let terms =
        [rounded(first, 1.0), rounded(second, -1.0), rounded(third, 1.0), [-(up_3 + down_3), -side * (up_3 - down_3)]];
    (terms, slope / sum * side, sum)
}

impl ShiftedSeries {
    /// From q (at most 0.044) and the two shifts, each at most half of |ln q| in size.
    #[must_use]
    pub fn new(nome: DoubleDouble, shifts: [DoubleDouble; 2]) -> Self {
        let (first, first_slope, first_size) = one_shift(nome, shifts[0]);
        let (second, second_slope, second_size) = one_shift(nome, shifts[1]);
        // The ratio goes into amplitudes only: what f64 holds of the smaller terms is enough.
        let q2 = nome.hi() * nome.hi();
        let (q4, q9) = (q2 * q2, q2 * q2 * q2 * q2 * nome.hi());
        let theta_3 = DoubleDouble::ONE + nome.scale(2.0) + (2.0 * (q4 + q9)).into();
        let theta_4 = DoubleDouble::ONE - nome.scale(2.0) + (2.0 * (q4 - q9)).into();
        let ratio = theta_4 * first_size / (theta_3 * second_size);
        Self { first, second, log_derivatives: [first_slope, second_slope], ratio }
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

/// The sum over odd multiples of an angle with this sine and cosine, and its slope.
#[inline(always)]
fn sum(terms: &OneShift, sin: f64, cos: f64) -> ([f64; 2], [f64; 2]) {
    let (c2, s2) = (1.0 - 2.0 * sin * sin, 2.0 * sin * cos);
    let ([mut c, mut s], mut order) = ([cos, sin], 1.0);
    let (mut value, mut slope) = ([0.0; 2], [0.0; 2]);
    for n in 0..terms.len() {
        let [cosh, sinh] = terms[n];
        value = [value[0] + cosh * s, value[1] - sinh * c];
        slope = [slope[0] + order * cosh * c, slope[1] + order * sinh * s];
        (c, s) = (c * c2 - s * s2, s * c2 + c * s2);
        order += 2.0;
    }
    (value, slope)
}

impl TwoShifts for ShiftedSeries {
    #[inline(always)]
    fn pair(&self, v: Turn) -> ShiftedPair {
        let (sin, cos) = v.sin_cos();
        let (first, first_slope) = sum(&self.first, sin, cos);
        // θ₂ is θ₁ a quarter turn on.
        let (second, second_slope) = sum(&self.second, cos, -sin);
        ShiftedPair { first, first_slope, second, second_slope, turns: [0.0; 2] }
    }
}
