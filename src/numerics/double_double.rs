use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number of 106 bits: the unevaluated sum of two f64, the second below half an ulp of the first.
///
/// Sums, products, quotients and roots are right to a few parts in 2¹⁰⁴ where nothing under- or overflows: magnitudes
/// from 1e-270 to 1e290. Only IEEE operations, one correctly rounded result each: the same bits on every machine.
/// Algorithms: `[Dekker71]`, `[HidaLiBailey01]`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

/// a + b exactly, as the rounded sum and its error. Any order of magnitudes.
#[inline(always)]
#[must_use]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_rounded = sum - a;
    (sum, (a - (sum - b_rounded)) + (b - b_rounded))
}

/// The same for |a| ≥ |b|, or a = 0.
#[inline(always)]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a × b exactly, as the rounded product and its error.
///
/// Where the target has no fused multiply-add, `mul_add` would be a library call; splitting gives the same two numbers.
#[inline(always)]
#[must_use]
pub fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if cfg!(any(target_feature = "fma", target_arch = "aarch64")) {
        (product, a.mul_add(b, -product))
    } else {
        let ((a_hi, a_lo), (b_hi, b_lo)) = (split(a), split(b));
        (product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo)
    }
}

/// Two halves of 26 bits each, whose products are exact.
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let scaled = SPLITTER * a;
    let hi = scaled - (scaled - a);
    (hi, a - hi)
}

impl DoubleDouble {
    /// 0.
    pub const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    /// 1.
    pub const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    /// π.
    pub const PI: Self = Self { hi: std::f64::consts::PI, lo: 1.224_646_799_147_353_2e-16 };

    /// 1/2π: turns in a radian.
    pub const TURNS_PER_RADIAN: Self = Self { hi: 0.159_154_943_091_895_35, lo: -9.839_338_337_591_243e-18 };

    /// The number `hi + lo`, where `lo` is already below half an ulp of `hi` (as in tables).
    #[must_use]
    pub const fn from_parts(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// a + b exactly.
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// a × b exactly.
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_prod(a, b);
        Self { hi, lo }
    }

    /// The nearest f64.
    #[must_use]
    pub const fn hi(self) -> f64 {
        self.hi
    }

    /// What the nearest f64 leaves.
    #[must_use]
    pub const fn lo(self) -> f64 {
        self.lo
    }

    /// Whether the number is exactly zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.hi == 0.0
    }

    /// |x|.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// x², one multiplication cheaper than x × x.
    #[inline]
    #[must_use]
    pub fn square(self) -> Self {
        let (p, e) = two_prod(self.hi, self.hi);
        let (hi, lo) = quick_two_sum(p, e + 2.0 * (self.hi * self.lo));
        Self { hi, lo }
    }

    /// 1/x.
    #[must_use]
    pub fn recip(self) -> Self {
        Self::ONE / self
    }

    /// x × 2ⁿ given as that power of two: exact.
    #[inline]
    #[must_use]
    pub fn scale(self, power_of_two: f64) -> Self {
        Self { hi: self.hi * power_of_two, lo: self.lo * power_of_two }
    }

    /// √x; 0 for 0, NaN for a negative number.
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        // Karp: one Newton step on 1/√x, whose last product needs 53 bits only.
        let root = self.hi.sqrt();
        let (p, e) = two_prod(root, root);
        let rest = ((self.hi - p) - e) + self.lo;
        let (hi, lo) = quick_two_sum(root, rest / (2.0 * root));
        Self { hi, lo }
    }

    /// (cos x, sin x), each within |x| parts in 2¹⁰³, or within a few where |x| is below 1.
    ///
    /// The series at x / 2ⁿ, below ½, then n times squared as a point of the unit circle.
    #[must_use]
    pub fn cos_sin(self) -> (Self, Self) {
        const TERMS: u32 = 28; // 2⁻²⁸ / 28! is 1e-38
        let mut angle = self;
        let mut halvings = 0;
        while angle.hi.abs() > 0.5 && angle.hi.is_finite() {
            angle = angle.scale(0.5);
            halvings += 1;
        }
        // 1 − x²/(2·1) (1 − x²/(4·3) (…)) and 1 − x²/(3·2) (1 − x²/(5·4) (…)), from the innermost on.
        let square = angle.square();
        let nested = |first: u32| {
            (0..TERMS / 2)
                .map(|half| first + 2 * half)
                .rev()
                .fold(Self::ONE, |rest, n| Self::ONE - square * rest / Self::from(f64::from(n * (n - 1))))
        };
        let (mut cosine, mut sine) = (nested(2), angle * nested(3));
        for _ in 0..halvings {
            (cosine, sine) = (cosine.square() - sine.square(), (cosine * sine).scale(2.0));
        }
        (cosine, sine)
    }
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (t, f) = two_sum(self.lo, other.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Self { hi, lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (p, e) = two_prod(self.hi, other.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * other.lo + self.lo * other.hi));
        Self { hi, lo }
    }
}

impl Mul<f64> for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let (p, e) = two_prod(self.hi, other);
        let (hi, lo) = quick_two_sum(p, e + self.lo * other);
        Self { hi, lo }
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        // What a first quotient leaves is below an ulp of `self`: f64 holds as much of it as counts.
        let quotient = self.hi / other.hi;
        let (p, e) = two_prod(quotient, other.hi);
        let rest = ((self.hi - p) - e) + (self.lo - quotient * other.lo);
        let (hi, lo) = quick_two_sum(quotient, rest / other.hi);
        Self { hi, lo }
    }
}

impl AddAssign for DoubleDouble {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&other.lo),
            order => order,
        }
    }
}
