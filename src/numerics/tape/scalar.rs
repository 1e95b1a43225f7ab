use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::numerics::{DoubleDouble, convolution};

/// What a tape computes with. Its functions are the same bits on every machine.
pub trait Scalar:
    Copy
    + Debug
    + Send
    + PartialOrd
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + 'static
{
    /// The nearest there is.
    fn from_double(value: DoubleDouble) -> Self;
    /// Exactly.
    fn to_double(self) -> DoubleDouble;
    /// Σ a(j) b(n − j) of two slices of n + 1 coefficients.
    fn convolution(a: &[Self], b: &[Self]) -> Self;
    /// √x.
    #[must_use]
    fn root(self) -> Self;
    /// eˣ.
    #[must_use]
    fn exponential(self) -> Self;
    /// ln x; not finite for what is not positive.
    #[must_use]
    fn logarithm(self) -> Self;
    /// The angle between −π/2 and π/2 with this tangent.
    #[must_use]
    fn arctangent(self) -> Self;
    /// (sin x, cos x).
    #[must_use]
    fn sine_cosine(self) -> (Self, Self);

    /// To f64.
    #[must_use]
    fn rounded(self) -> f64 {
        self.to_double().hi()
    }
}

impl Scalar for f64 {
    fn from_double(value: DoubleDouble) -> Self {
        value.hi()
    }

    fn to_double(self) -> DoubleDouble {
        DoubleDouble::from(self)
    }

    #[inline]
    fn convolution(a: &[Self], b: &[Self]) -> Self {
        a.iter().zip(b.iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b)
    }

    fn root(self) -> Self {
        self.sqrt()
    }

    fn exponential(self) -> Self {
        libm::exp(self)
    }

    fn logarithm(self) -> Self {
        libm::log(self)
    }

    fn arctangent(self) -> Self {
        libm::atan(self)
    }

    fn sine_cosine(self) -> (Self, Self) {
        libm::sincos(self)
    }
}

impl Scalar for DoubleDouble {
    fn from_double(value: DoubleDouble) -> Self {
        value
    }

    fn to_double(self) -> DoubleDouble {
        self
    }

    fn convolution(a: &[Self], b: &[Self]) -> Self {
        convolution(a, b)
    }

    fn root(self) -> Self {
        self.sqrt()
    }

    fn exponential(self) -> Self {
        self.exp()
    }

    fn logarithm(self) -> Self {
        self.ln()
    }

    fn arctangent(self) -> Self {
        self.atan()
    }

    fn sine_cosine(self) -> (Self, Self) {
        let (cosine, sine) = self.cos_sin();
        (sine, cosine)
    }
}
