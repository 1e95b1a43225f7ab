use super::{Jacobi, Theta, ThetaPair};
use crate::numerics::{DoubleDouble, Turn, exp_of_negative};

/// Sums over flips, for K′ ≤ K/2: the same functions after Jacobi's imaginary transformation, in the **other** nome
/// P = e^(−πK/2K′) ≤ 0.044. `[DLMF]` 20.7(viii).
///
/// With T = 2K′/K and κ = 2s/πT, θ₄(v − i s) is the sum of exp(−d²/πT + iκd), d = v − (n + ½)π, over all integers n, up to
/// a factor; θ₁ is the same with alternating signs. Each term is a Gaussian around one passage of the saddle, and on
/// the separatrix two of them are left. Nothing cancels, however near it is.
#[derive(Debug, Clone, Copy)]
pub struct FlipSum {
    jacobi: JacobiFlips,
    /// κ: turns of phase per turn of v.
    kappa: f64,
    /// (cos, sin) (n + ½)κπ, n = 0 to 3.
    directions: [[f64; 2]; 4],
    log_derivative: DoubleDouble,
    ratio_at_zero: DoubleDouble,
}

impl FlipSum {
    /// From P = e^(−π/T), 1/T = K/2K′ (at least 1), and κ, between −½ and ½.
    #[must_use]
    pub fn new(nome: DoubleDouble, inverse_width: DoubleDouble, kappa: DoubleDouble) -> Self {
        let (sin, cos) = (DoubleDouble::PI * kappa).scale(0.5).sin_cos();
        let [sin_twice, cos_twice] = [(sin * cos).scale(2.0), (cos + sin) * (cos - sin)];
        // (cos, sin) (n + ½)κπ. P^(n(n+1)) bounds the terms: at n = 4 f64 holds what counts of them.
        let mut directions = [[cos, sin]; 5];
        for n in 1..5 {
            let [c, s] = directions[n - 1];
            directions[n] = [c * cos_twice - s * sin_twice, s * cos_twice + c * sin_twice];
        }
        let nome_2 = nome.square();
        let nome_6 = nome_2.square() * nome_2;
        let times = |n: usize, power: DoubleDouble| directions[n].map(|part| part * power);
        let ([c1, s1], [c2, s2], [c3, s3]) = (times(1, nome_2), times(2, nome_6), times(3, nome_6.square()));
        let (p2, p6) = (nome_2.hi(), nome_6.hi());
        let [c4, s4] = directions[4].map(|part| part.hi() * (p6 * p6 * p6 * p2));
        let [d0, d1, d2, d3, _] = directions.map(|direction| direction.map(DoubleDouble::hi));
        let theta_4 = (c3 + c4.into()) + c2 + c1 + cos;
        let theta_1 = (DoubleDouble::from(s4) - s3) + s2 - s1 + sin;
        let slope = (s3 * 7.0 + (9.0 * s4).into()) + s2 * 5.0 + s1 * 3.0 + sin;
        Self {
            jacobi: JacobiFlips::new(nome, inverse_width),
            kappa: kappa.hi(),
            directions: [d0, d1, d2, d3],
            log_derivative: kappa - inverse_width * (slope / theta_4),
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

/// Where v lies between two saddles.
#[derive(Debug, Clone, Copy)]
pub struct Flip {
    /// e^(−2|v|/T): e^(−|u|) near the separatrix.
    x: f64,
    /// P/x: the same from the next saddle.
    y: f64,
    /// Between −¼ and ¼ turns.
    v: f64,
    /// Sign of v.
    side: f64,
    /// −1 where a half turn was taken off.
    half: f64,
}

/// sn, cn, dn as quotients of sums over flips.
#[derive(Debug, Clone, Copy)]
pub struct JacobiFlips {
    /// −4π/T: the exponent of x = e^(−2|v|/T) for v in turns.
    decay: f64,
    /// P.
    nome: f64,
    /// θ₃/θ₂, θ₄/θ₂, θ₄/θ₃ at 0.
    factors: [f64; 3],
}

impl JacobiFlips {
    /// From P = e^(−π/T) and 1/T = K/2K′ (at least 1).
    #[must_use]
    pub fn new(nome: DoubleDouble, inverse_width: DoubleDouble) -> Self {
        let decay = (DoubleDouble::PI * inverse_width).scale(-4.0).hi();
        let mut flips = Self { decay, nome: nome.hi(), factors: [1.0; 3] };
        let [_, cn, dn] = flips.jacobi(Flip { x: 1.0, y: nome.hi(), v: 0.0, side: 1.0, half: 1.0 });
        flips.factors = [dn / cn, 1.0 / cn, 1.0 / dn];
        flips
    }
}

impl Jacobi for JacobiFlips {
    type Place = Flip;

    #[inline(always)]
    fn place(&self, v: Turn) -> Flip {
        let (taken, v) = v.without_half_turn();
        let x = exp_of_negative(self.decay * v.abs());
        Flip { x, y: (self.nome / x).min(1.0), v, side: v.signum(), half: if taken { -1.0 } else { 1.0 } }
    }

    #[inline(always)]
    fn jacobi(&self, Flip { x, y, side, half, .. }: Flip) -> [f64; 3] {
        let p = self.nome;
        let (p2, x2, y2) = (p * p, x * x, y * y);
        let p4 = p2 * p2;
        // Terms n = 0, 1, 2 and -1, -2, -3 of the sums over flips; widths are half of the pair's, so squares appear.
        let (ahead, ahead_odd) = (1.0 + p4 * p4 * y2 * y2, p2 * y2);
        let (behind, behind_odd) = (p4 * x2 * x2, x2 * (1.0 + p4 * p4 * p4 * x2 * x2));
        let over_theta_4 = 1.0 / ((ahead + behind) + (ahead_odd + behind_odd));
        let theta_1 = (ahead + behind) - (ahead_odd + behind_odd);
        // The same for θ₃ and θ₂, whose Gaussians sit between: x, Py, P²x³, P⁵y³, P⁸x⁵, P¹³y⁵.
        let even = x * (1.0 + p4 * p4 * x2 * x2) + p4 * p * y2 * y;
        let odd = p * y * (1.0 + p4 * p4 * p4 * y2 * y2) + p2 * x2 * x;
        let [sn, cn, dn] = self.factors;
        [
            half * side * sn * theta_1 * over_theta_4,
            half * cn * (even - odd) * over_theta_4,
            dn * (even + odd) * over_theta_4,
        ]
    }
}

impl Jacobi for FlipSum {
    type Place = Flip;

    #[inline(always)]
    fn place(&self, v: Turn) -> Flip {
        self.jacobi.place(v)
    }

    #[inline(always)]
    fn jacobi(&self, at: Flip) -> [f64; 3] {
        self.jacobi.jacobi(at)
    }
}

impl Theta for FlipSum {
    #[inline(always)]
    fn pair(&self, Flip { x, y, v, side, half }: Flip) -> ThetaPair {
        let p = self.jacobi.nome;
        let (p2, x2) = (p * p, x * x);
        let p4 = p2 * p2;
        let p6 = p4 * p2;
        // P^(n(n+1)) x^(-n) for n = 0 to 3, and P^(n(n+1)) x^(n+1) for -1-n.
        let ahead = [1.0, p * y, p4 * y * y, p6 * p2 * p * y * y * y];
        let behind = [x, p2 * x2, p6 * x2 * x, p6 * p6 * x2 * x2];
        let ([mut a_re, mut a_im], [mut b_re, mut b_im]) = ([0.0; 2], [0.0; 2]);
        let mut sign = -1.0; // (−1)ⁿ at n = 3, smallest terms first
        for n in (0..ahead.len()).rev() {
            let [cos, sin] = self.directions[n];
            let (sum, difference) = (ahead[n] + behind[n], ahead[n] - behind[n]);
            a_re += sum * cos;
            a_im -= difference * sin;
            b_re += sign * difference * cos;
            b_im -= sign * sum * sin;
            sign = -sign;
        }
        // For v < 0: θ₄ is even and θ₁ odd in v - i s, so both turn into conjugates.
        let b_side = half * side;
        ThetaPair { a: [a_re, side * a_im], b: [b_side * b_re, half * b_im], turns: self.kappa * v }
    }
}
