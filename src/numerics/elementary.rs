use super::DoubleDouble;

impl DoubleDouble {
    /// ln 2.
    const LN_2: Self = Self::from_parts(std::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);

    /// eˣ, relative error a few parts in 2¹⁰⁰; 0 below -700, infinite above 709.
    #[must_use]
    pub fn exp(self) -> Self {
        if self.hi() < -700.0 {
            return Self::ZERO;
        }
        if self.hi() > 709.0 {
            return Self::from(f64::INFINITY);
        }
        // x = k ln 2 + 64 r, |r| < 0.0055: the series of e^r - 1 needs twelve terms, and p -> 2p + p² doubles r
        // without losing what is small.
        let k = libm::rint(self.hi() / std::f64::consts::LN_2);
        let r = (self - Self::LN_2 * k).scale(1.0 / 64.0);
        let mut p = r * series(&INVERSE_FACTORIALS[1..13], 1, 6, r);
        for _ in 0..6 {
            p = p.scale(2.0) + p.square();
        }
        (p + Self::ONE).scale(libm::exp2(k))
    }

    /// ln x, error a few parts in 2¹⁰⁰ of the larger of |ln x| and 1; not finite for what is not positive.
    #[must_use]
    pub fn ln(self) -> Self {
        let first = libm::log(self.hi());
        if !first.is_finite() {
            return Self::from(first);
        }
        // Newton's step on e^y = x, which doubles the digits.
        let first = Self::from(first);
        first + (self * (-first).exp() - Self::ONE)
    }

    /// The angle between −π/2 and π/2 whose tangent is x, error a few parts in 2¹⁰⁰.
    #[must_use]
    pub fn atan(self) -> Self {
        let first = Self::from(libm::atan(self.hi()));
        if !self.hi().is_finite() {
            return first;
        }
        // What is left is an angle below 1e-16, and its own tangent.
        let (cosine, sine) = first.cos_sin();
        first + (self * cosine - sine) / (cosine + self * sine)
    }

    /// (sinh x, cosh x), sinh with small relative error however small x.
    #[must_use]
    pub fn sinh_cosh(self) -> (Self, Self) {
        if self.hi().abs() > 0.5 {
            let up = self.exp();
            let down = up.recip();
            return ((up - down).scale(0.5), (up + down).scale(0.5));
        }
        let square = self.square();
        (self * series(&INVERSE_FACTORIALS[1..25], 2, 7, square), series(&INVERSE_FACTORIALS[..26], 2, 8, square))
    }

    /// (sin x, cos x) for |x| ≤ π/4, where nothing has to be reduced.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        let square = -self.square();
        (self * series(&INVERSE_FACTORIALS[1..], 2, 9, square), series(&INVERSE_FACTORIALS, 2, 10, square))
    }
}

/// Horner's rule over every `stride`-th coefficient. Terms after the first `exact` are below 1e-16 and need f64 only.
#[inline]
fn series(coefficients: &[DoubleDouble], stride: usize, exact: usize, x: DoubleDouble) -> DoubleDouble {
    let (large, small) = coefficients.split_at(exact * stride);
    let every = |part| <[DoubleDouble]>::chunks(part, stride).filter_map(|chunk| chunk.first());
    let rest = every(small).rev().fold(0.0, |sum, coefficient| sum * x.hi() + coefficient.hi());
    every(large).rev().fold(DoubleDouble::from(rest), |sum, &coefficient| sum * x + coefficient)
}

/// eˣ for x ≤ 0, at least e^(−700), in f64: without branches, so that loops over samples become vector code.
#[inline(always)]
#[must_use]
pub fn exp_of_negative(x: f64) -> f64 {
    const MAGIC: f64 = 6_755_399_441_055_744.0; // 1.5 × 2⁵²: adding it leaves the nearest integer in the low bits
    const LN_2_HI: f64 = 0.693_147_180_369_123_8; // 33 bits, so that k times it is exact
    const LN_2_LO: f64 = 1.908_214_929_270_587_7e-10;
    let x = x.max(-700.0);
    let shifted = x * std::f64::consts::LOG2_E + MAGIC;
    let k = shifted - MAGIC;
    let r = (x - k * LN_2_HI) - k * LN_2_LO;
    let rest = polynomial(&FROM_SECOND, r);
    let power = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
    power + power * (r + r * r * rest)
}

/// Horner's rule, without closures or iterators: those are not inlined everywhere.
#[inline(always)]
pub(super) fn polynomial<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let mut sum = 0.0;
    for n in (0..N).rev() {
        sum = sum * x + coefficients[n];
    }
    sum
}

/// 1/n! in f64, n = 2 to 13.
const FROM_SECOND: [f64; 12] = {
    let mut coefficients = [0.0; 12];
    let mut n = 0;
    while n < 12 {
        coefficients[n] = INVERSE_FACTORIALS[n + 2].hi();
        n += 1;
    }
    coefficients
};

/// 1/n!, n = 0 to 29.
#[allow(clippy::unreadable_literal, reason = "digits are compared whole, not in groups")]
const INVERSE_FACTORIALS: [DoubleDouble; 30] = [
    DoubleDouble::from_parts(1.0, 0.0),
    DoubleDouble::from_parts(1.0, 0.0),
    DoubleDouble::from_parts(0.5, 0.0),
    DoubleDouble::from_parts(0.16666666666666666, 9.25185853854297e-18),
    DoubleDouble::from_parts(0.041666666666666664, 2.3129646346357427e-18),
    DoubleDouble::from_parts(0.008333333333333333, 1.1564823173178714e-19),
    DoubleDouble::from_parts(0.001388888888888889, -5.300543954373577e-20),
    DoubleDouble::from_parts(0.0001984126984126984, 1.7209558293420705e-22),
    DoubleDouble::from_parts(2.48015873015873e-05, 2.1511947866775882e-23),
    DoubleDouble::from_parts(2.7557319223985893e-06, -1.858393274046472e-22),
    DoubleDouble::from_parts(2.755731922398589e-07, 2.3767714622250297e-23),
    DoubleDouble::from_parts(2.505210838544172e-08, -1.448814070935912e-24),
    DoubleDouble::from_parts(2.08767569878681e-09, -1.20734505911326e-25),
    DoubleDouble::from_parts(1.6059043836821613e-10, 1.2585294588752098e-26),
    DoubleDouble::from_parts(1.1470745597729725e-11, 2.0655512752830745e-28),
    DoubleDouble::from_parts(7.647163731819816e-13, 7.03872877733453e-30),
    DoubleDouble::from_parts(4.779477332387385e-14, 4.399205485834081e-31),
    DoubleDouble::from_parts(2.8114572543455206e-15, 1.6508842730861433e-31),
    DoubleDouble::from_parts(1.5619206968586225e-16, 1.1910679660273754e-32),
    DoubleDouble::from_parts(8.22063524662433e-18, 2.2141894119604265e-34),
    DoubleDouble::from_parts(4.110317623312165e-19, 1.4412973378659527e-36),
    DoubleDouble::from_parts(1.9572941063391263e-20, -1.3643503830087908e-36),
    DoubleDouble::from_parts(8.896791392450574e-22, -7.911402614872376e-38),
    DoubleDouble::from_parts(3.868170170630684e-23, -8.843177655482344e-40),
    DoubleDouble::from_parts(1.6117375710961184e-24, -3.6846573564509766e-41),
    DoubleDouble::from_parts(6.446950284384474e-26, -1.9330404233703465e-42),
    DoubleDouble::from_parts(2.4795962632247976e-27, -1.2953730964765229e-43),
    DoubleDouble::from_parts(9.183689863795546e-29, 1.4303150396787322e-45),
    DoubleDouble::from_parts(3.279889237069838e-30, 1.5117542744029879e-46),
    DoubleDouble::from_parts(1.1309962886447716e-31, 1.0498015412959506e-47),
];
