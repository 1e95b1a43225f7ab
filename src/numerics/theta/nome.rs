use super::{Jacobi, Theta, ThetaPair};
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
/// Multiples of s that the constants take: Q^(n² − n/2), n = 5, is below 1e-30.
const MULTIPLES: usize = 9;

impl NomeSeries {
    /// From Q (0 to 0.044) and s, at most a quarter of |ln Q| in size.
    #[must_use]
    pub fn new(nome: DoubleDouble, shift: DoubleDouble) -> Self {
        let (sinh, cosh) = shift.sinh_cosh();
        // (cosh, sinh) ks, each from the two before it.
        let mut multiples = [[DoubleDouble::ONE, DoubleDouble::ZERO]; MULTIPLES];
        multiples[1] = [cosh, sinh];
        for k in 2..MULTIPLES {
            multiples[k] = [0, 1].map(|part| cosh.scale(2.0) * multiples[k - 1][part] - multiples[k - 2][part]);
        }
        // Q^(n² − n/2) bounds the terms: from n = 4, and for θ₁, which nothing multiplies by the time, from n = 2 on, f64
        // holds what counts of them.
        let (nome_2, nome_4) = (nome.square(), nome.square().square());
        let squares = [-nome, nome_4, -(nome_4.square() * nome)].map(|square| square.scale(2.0));
        let even = [0, 1, 2].map(|n| multiples[2 * n + 2].map(|multiple| multiple * squares[n]));
        let (q2, q4) = (nome_2.hi(), nome_4.hi());
        let last = multiples[8].map(|multiple| 2.0 * (q4 * q4 * q4 * q4) * multiple.hi());
        let theta_4 = ((even[2][0] + last[0].into()) + even[1][0] + even[0][0]) + DoubleDouble::ONE;
        let slope = ((even[2][1] * 3.0 + (4.0 * last[1]).into()) + even[1][1].scale(2.0) + even[0][1]).scale(2.0);
        let oblongs = [1.0, -q2, q4 * q2, -(q4 * q4 * q4)];
        let odd = [0, 1, 2, 3].map(|n| multiples[2 * n + 1].map(|multiple| multiple.hi() * oblongs[n]));
        let theta_1 = sinh - multiples[3][1] * nome_2 + (odd[2][1] + odd[3][1]).into();
        Self {
            even: even.map(|term| term.map(DoubleDouble::hi)),
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

/// (cos, sin) of multiples of v.
#[derive(Debug, Clone, Copy)]
pub struct Multiples {
    /// 2v, 4v, 6v, 8v.
    even: [[f64; 2]; 4],
    /// v, 3v, 5v, 7v, 9v.
    odd: [[f64; 2]; 5],
}

impl Multiples {
    #[inline(always)]
    fn new([s1, c1]: [f64; 2]) -> Self {
        let (c2, s2) = (1.0 - 2.0 * s1 * s1, 2.0 * s1 * c1);
        let (c4, s4) = (1.0 - 2.0 * s2 * s2, 2.0 * s2 * c2);
        let (c6, s6) = (c4 * c2 - s4 * s2, s4 * c2 + c4 * s2);
        let (c8, s8) = (1.0 - 2.0 * s4 * s4, 2.0 * s4 * c4);
        let (c3, s3) = (c2 * c1 - s2 * s1, s2 * c1 + c2 * s1);
        let (c5, s5) = (c4 * c1 - s4 * s1, s4 * c1 + c4 * s1);
        let (c7, s7) = (c4 * c3 - s4 * s3, s4 * c3 + c4 * s3);
        let (c9, s9) = (c4 * c5 - s4 * s5, s4 * c5 + c4 * s5);
        Self { even: [[c2, s2], [c4, s4], [c6, s6], [c8, s8]], odd: [[c1, s1], [c3, s3], [c5, s5], [c7, s7], [c9, s9]] }
    }
}

impl Jacobi for NomeSeries {
    type Place = Multiples;

    #[inline(always)]
    fn place(&self, v: Turn) -> Multiples {
        self.jacobi.place(v)
    }

    #[inline(always)]
    fn jacobi(&self, at: Multiples) -> [f64; 3] {
        self.jacobi.jacobi(at)
    }
}

impl Theta for NomeSeries {
    #[inline(always)]
    fn pair(&self, at: Multiples) -> ThetaPair {
        let (mut a, mut b) = ([0.0; 2], [0.0; 2]);
        // Smallest terms first.
        for n in (0..EVEN).rev() {
            let ([cosh, sinh], [cos, sin]) = (self.even[n], at.even[n]);
            a = [a[0] + cosh * cos, a[1] + sinh * sin];
        }
        for n in (0..ODD).rev() {
            let ([cosh, sinh], [cos, sin]) = (self.odd[n], at.odd[n]);
            b = [b[0] + cosh * sin, b[1] - sinh * cos];
        }
        ThetaPair { a: [1.0 + a[0], a[1]], b, turns: 0.0 }
    }
}

/// sn, cn, dn as quotients of theta functions of Jacobi's own nome √Q. `[DLMF]` 20.2, 22.2.
#[derive(Debug, Clone, Copy)]
pub struct JacobiSeries {
    /// 2 Q^(n²/2), n = 1 to 4.
    squares: [f64; 4],
    /// Q^(n(n+1)/2), n = 1 to 4.
    triangles: [f64; 4],
    /// θ₃/θ₂, θ₄/θ₂, θ₄/θ₃ at 0.
    factors: [f64; 3],
}

impl JacobiSeries {
    /// From Q (0 to 0.044).
    #[must_use]
    pub fn new(nome: DoubleDouble) -> Self {
        let (q, root) = (nome.hi(), nome.sqrt().hi());
        let (q2, q4) = (q * q, q * q * q * q);
        let mut series = Self {
            squares: [2.0 * root, 2.0 * q2, 2.0 * root * q4, 2.0 * q4 * q4],
            triangles: [q, q2 * q, q4 * q2, q4 * q4 * q2],
            factors: [1.0; 3],
        };
        let [_, cn, dn] = series.jacobi(Multiples::new([0.0, 1.0])); // θ₂/θ₄ and θ₃/θ₄ while the factors are 1
        series.factors = [dn / cn, 1.0 / cn, 1.0 / dn];
        series
    }
}

impl Jacobi for JacobiSeries {
    type Place = Multiples;

    #[inline(always)]
    fn place(&self, v: Turn) -> Multiples {
        let (sin, cos) = v.sin_cos();
        Multiples::new([sin, cos])
    }

    #[inline(always)]
    fn jacobi(&self, Multiples { even, odd }: Multiples) -> [f64; 3] {
        let [[c2, _], [c4, _], [c6, _], [c8, _]] = even;
        let [[c1, s1], [c3, s3], [c5, s5], [c7, s7], [c9, s9]] = odd;
        let [a1, a2, a3, a4] = self.squares;
        let (common, differing) = (1.0 + (a4 * c8 + a2 * c4), a3 * c6 + a1 * c2);
        let over_theta_4 = 1.0 / (common - differing);
        let theta_3 = common + differing;
        let [b1, b2, b3, b4] = self.triangles;
        let theta_1 = s1 + (((b4 * s9 - b3 * s7) + b2 * s5) - b1 * s3);
        let theta_2 = c1 + (((b4 * c9 + b3 * c7) + b2 * c5) + b1 * c3);
        let [sn, cn, dn] = self.factors;
        [sn * theta_1 * over_theta_4, cn * theta_2 * over_theta_4, dn * theta_3 * over_theta_4]
    }
}
