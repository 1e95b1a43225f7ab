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

const TERMS: usize = 4;
/// Terms of the constants, in double-double: q^(n²) is below 1e-48 at n = 6.
const EXACT_TERMS: usize = 6;

/// ± q^(n(n+1)) (cosh, sinh)(2n+1)s, divided by e^|s|/2.
type OneShift = [[f64; 2]; TERMS];

/// The coefficients, d/ds ln θ₂(i s), and θ₂(i s) in the same units.
fn one_shift(nome: DoubleDouble, shift: DoubleDouble) -> (OneShift, DoubleDouble, DoubleDouble) {
    let side = if shift.hi() < 0.0 { -1.0 } else { 1.0 };
    let size = shift.abs();
    // q^(n(n+1)) e^(±(2n+1)s − s): |s| is at most half of |ln q|, so that neither grows.
    let (up_step, down_step) = (nome * size.scale(2.0).exp(), nome * size.scale(-2.0).exp());
    let (mut up, mut down) = (DoubleDouble::ONE, size.scale(-2.0).exp());
    let mut power = nome; // q^(2n+1)
    let (mut sum, mut slope) = (DoubleDouble::ZERO, DoubleDouble::ZERO);
    let (mut terms, mut sign, mut order) = ([[0.0; 2]; TERMS], 1.0, 1.0);
    for n in 0..EXACT_TERMS {
        if let Some(term) = terms.get_mut(n) {
            *term = [sign * (up + down).hi(), side * sign * (up - down).hi()];
        }
        sum += up + down;
        slope += (up - down) * order;
        (up, down, power) = (up * up_step * power, down * down_step * power, power * nome.square());
        (sign, order) = (-sign, order + 2.0);
    }
    (terms, slope / sum * side, sum)
}

impl ShiftedSeries {
    /// From q (at most 0.044) and the two shifts, each at most half of |ln q| in size.
    #[must_use]
    pub fn new(nome: DoubleDouble, shifts: [DoubleDouble; 2]) -> Self {
        let (first, first_slope, first_size) = one_shift(nome, shifts[0]);
        let (second, second_slope, second_size) = one_shift(nome, shifts[1]);
        let (mut theta_3, mut theta_4) = (DoubleDouble::ONE, DoubleDouble::ONE);
        let (mut power, mut step) = (nome.scale(2.0), nome.square() * nome);
        for n in 1..=EXACT_TERMS {
            theta_3 += power;
            theta_4 += if n % 2 == 0 { power } else { -power };
            (power, step) = (power * step, step * nome.square());
        }
        let ratio = theta_4 / theta_3 * (first_size / second_size);
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
#[inline]
fn sum(terms: &OneShift, sin: f64, cos: f64) -> ([f64; 2], [f64; 2]) {
    let (c2, s2) = (1.0 - 2.0 * sin * sin, 2.0 * sin * cos);
    let ([mut c, mut s], mut order) = ([cos, sin], 1.0);
    let (mut value, mut slope) = ([0.0; 2], [0.0; 2]);
    for [cosh, sinh] in terms {
        value = [value[0] + cosh * s, value[1] - sinh * c];
        slope = [slope[0] + order * cosh * c, slope[1] + order * sinh * s];
        (c, s) = (c * c2 - s * s2, s * c2 + c * s2);
        order += 2.0;
    }
    (value, slope)
}

impl TwoShifts for ShiftedSeries {
    #[inline]
    fn pair(&self, v: Turn) -> ShiftedPair {
        let (sin, cos) = v.sin_cos();
        let (first, first_slope) = sum(&self.first, sin, cos);
        // θ₂ is θ₁ a quarter turn on.
        let (second, second_slope) = sum(&self.second, cos, -sin);
        ShiftedPair { first, first_slope, second, second_slope, turns: [0.0; 2] }
    }
}
