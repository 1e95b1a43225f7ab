use super::{Theta, ThetaPair};
use crate::numerics::{DoubleDouble, Turn};

/// Series in the nome, for K′ ≥ K/2: Q ≤ e^(−π) = 0.043, where four terms of each reach the last bit.
#[derive(Debug, Clone, Copy)]
pub struct NomeSeries {
    /// ± 2 Q^(n²) (cosh, sinh) 2ns, n = 1 to 3.
    even: [[f64; 2]; EVEN],
    /// ± Q^(n²+n) (cosh, sinh) (2n+1)s, n = 0 to 3; θ₁'s factor 2 Q^(1/4) left out.
    odd: [[f64; 2]; ODD],
    jacobi: JacobiSeries,
    log_derivative: DoubleDouble,
    ratio_at_zero: DoubleDouble,
}

const EVEN: usize = 3;
const ODD: usize = 4;
/// Terms of the constants, in double-double: Q^(n² − n/2) is below 1e-45 at n = 6.
const EXACT_TERMS: usize = 6;

impl NomeSeries {
    /// From Q (0 to 0.044) and s, at most a quarter of |ln Q| in size.
    #[must_use]
    pub fn new(nome: DoubleDouble, shift: DoubleDouble) -> Self {
        let (sinh, cosh) = shift.sinh_cosh();
        let mut multiples = [[DoubleDouble::ONE, DoubleDouble::ZERO]; 2 * EXACT_TERMS + 2]; // (cosh, sinh) k s
        for k in 1..multiples.len() {
            let [c, s] = multiples[k - 1];
            multiples[k] = [c * cosh + s * sinh, s * cosh + c * sinh];
        }
        let nome_squared = nome.square();
        // step = ± Q^(2n+1), which leads from Q^(n²) to Q^((n+1)²), and times Q from Q^(n²+n) to the next of those.
        let (mut square, mut oblong, mut step) = (DoubleDouble::ONE, DoubleDouble::ONE, -nome);
        let mut order = 0.0;
        let (mut even, mut odd) = ([[0.0; 2]; EVEN], [[0.0; 2]; ODD]);
        let (mut theta_4, mut slope, mut theta_1) = (DoubleDouble::ONE, DoubleDouble::ZERO, DoubleDouble::ZERO);
        for n in 0..=EXACT_TERMS {
            let [c, s] = multiples[2 * n + 1];
            theta_1 += s * oblong;
            if n < ODD {
                odd[n] = [(c * oblong).hi(), (s * oblong).hi()];
            }
            if n == EXACT_TERMS {
                break;
            }
            square = square * step;
            oblong = oblong * step * nome;
            step = step * nome_squared;
            let [c, s] = multiples[2 * n + 2].map(|multiple| multiple * square.scale(2.0));
            theta_4 += c;
            order += 2.0;
            slope += s * order;
            if n < EVEN {
                even[n] = [c.hi(), s.hi()];
            }
        }
        Self {
            even,
            odd,
            jacobi: JacobiSeries::new(nome),
            log_derivative: slope / theta_4,
            ratio_at_zero: theta_4 / theta_1.abs(),
        }
    }

    /// d/ds ln θ₄(i s).
    #[must_use]
    pub fn log_derivative(&self) -> DoubleDouble {
        self.log_derivative
    }

    /// |θ₄/θ₁| of [`Theta::pair`] at v = 0.
    #[must_use]
    pub fn ratio_at_zero(&self) -> DoubleDouble {
        self.ratio_at_zero
    }
}

/// sin and cos of v.
#[derive(Debug, Clone, Copy)]
pub struct SinCos([f64; 2]);

impl Theta for NomeSeries {
    type Place = SinCos;

    #[inline]
    fn place(&self, v: Turn) -> SinCos {
        let (sin, cos) = v.sin_cos();
        SinCos([sin, cos])
    }

    #[inline]
    fn jacobi(&self, at: SinCos) -> [f64; 3] {
        self.jacobi.at(at)
    }

    #[inline]
    fn pair(&self, SinCos([sin, cos]): SinCos) -> ThetaPair {
        let (c2, s2) = (1.0 - 2.0 * sin * sin, 2.0 * sin * cos);
        let ([mut c, mut s], [mut re, mut im]) = ([1.0, 0.0], [0.0, 0.0]);
        for [cosh, sinh] in self.even {
            (c, s) = (c * c2 - s * s2, s * c2 + c * s2);
            re += cosh * c;
            im += sinh * s;
        }
        let a = [1.0 + re, im];
        let ([mut c, mut s], [mut re, mut im]) = ([cos, sin], [0.0, 0.0]);
        for [cosh, sinh] in self.odd {
            re += cosh * s;
            im -= sinh * c;
            (c, s) = (c * c2 - s * s2, s * c2 + c * s2);
        }
        ThetaPair { a, b: [re, im], turns: 0.0 }
    }
}

/// sn, cn, dn as quotients of theta functions of Jacobi's own nome √Q. `[DLMF]` 20.2, 22.2.
#[derive(Debug, Clone, Copy)]
struct JacobiSeries {
    /// 2 Q^(n²/2), n = 1 to 4.
    squares: [f64; 4],
    /// Q^(n(n+1)/2), n = 1 to 4.
    triangles: [f64; 4],
    /// θ₃/θ₂, θ₄/θ₂, θ₄/θ₃ at 0.
    factors: [f64; 3],
}

impl JacobiSeries {
    fn new(nome: DoubleDouble) -> Self {
        let (q, root) = (nome.hi(), nome.sqrt().hi());
        let (q2, q4) = (q * q, q * q * q * q);
        let mut series = Self {
            squares: [2.0 * root, 2.0 * q2, 2.0 * root * q4, 2.0 * q4 * q4],
            triangles: [q, q2 * q, q4 * q2, q4 * q4 * q2],
            factors: [1.0; 3],
        };
        let [_, cn, dn] = series.at(SinCos([0.0, 1.0])); // θ₂/θ₄ and θ₃/θ₄ while the factors are 1
        series.factors = [dn / cn, 1.0 / cn, 1.0 / dn];
        series
    }

    #[inline]
    fn at(&self, SinCos([s1, c1]): SinCos) -> [f64; 3] {
        let (c2, s2) = (1.0 - 2.0 * s1 * s1, 2.0 * s1 * c1);
        let (c4, s4) = (1.0 - 2.0 * s2 * s2, 2.0 * s2 * c2);
        let (c6, c8) = (c4 * c2 - s4 * s2, 1.0 - 2.0 * s4 * s4);
        let [a1, a2, a3, a4] = self.squares;
        let (common, differing) = (1.0 + (a4 * c8 + a2 * c4), a3 * c6 + a1 * c2);
        let over_theta_4 = 1.0 / (common - differing);
        let theta_3 = common + differing;
        let (c3, s3) = (c2 * c1 - s2 * s1, s2 * c1 + c2 * s1);
        let (c5, s5) = (c4 * c1 - s4 * s1, s4 * c1 + c4 * s1);
        let (c7, s7) = (c4 * c3 - s4 * s3, s4 * c3 + c4 * s3);
        let (c9, s9) = (c4 * c5 - s4 * s5, s4 * c5 + c4 * s5);
        let [b1, b2, b3, b4] = self.triangles;
        let theta_1 = s1 + (((b4 * s9 - b3 * s7) + b2 * s5) - b1 * s3);
        let theta_2 = c1 + (((b4 * c9 + b3 * c7) + b2 * c5) + b1 * c3);
        let [sn, cn, dn] = self.factors;
        [sn * theta_1 * over_theta_4, cn * theta_2 * over_theta_4, dn * theta_3 * over_theta_4]
    }
}
