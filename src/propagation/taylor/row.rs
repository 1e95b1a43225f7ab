use std::array::from_fn;
use std::ops::{Add, AddAssign, Mul, Sub};

use crate::numerics::Four;

/// One Taylor coefficient of a vector or quaternion, in one register; three-vectors leave the last place 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub(super) struct Row(pub [f64; 4]);

/// What is compiled into the caller can use the caller's registers; a call could not.
macro_rules! component_wise {
    ($trait:ident, $method:ident, $operator:tt) => {
        impl $trait for Row {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(from_fn(
                    #[inline(always)]
                    |i| self.0[i] $operator other.0[i],
                ))
            }
        }
    };
}

component_wise!(Add, add, +);
component_wise!(Sub, sub, -);
component_wise!(Mul, mul, *);

impl AddAssign for Row {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Row {
    pub const ZERO: Self = Self([0.0; 4]);

    #[inline(always)]
    pub const fn splat(value: f64) -> Self {
        Self([value; 4])
    }

    #[inline(always)]
    pub const fn from_vector([x, y, z]: [f64; 3]) -> Self {
        Self([x, y, z, 0.0])
    }

    /// (y, z, x).
    #[inline(always)]
    pub const fn turned(self) -> Self {
        let Self([x, y, z, rest]) = self;
        Self([y, z, x, rest])
    }

    #[inline(always)]
    pub fn load<F: Four>(&self, proof: F::Proof) -> F {
        F::load(proof, &self.0)
    }

    /// One component in all places.
    #[inline(always)]
    pub const fn spread(&self, component: usize) -> Self {
        Self::splat(self.0[component])
    }

    /// The greater of each two magnitudes.
    #[inline(always)]
    pub fn largest(self, other: Self) -> Self {
        Self(from_fn(
            #[inline(always)]
            |i| {
                let (a, b) = (self.0[i].abs(), other.0[i].abs());
                if a > b { a } else { b }
            },
        ))
    }

    /// The largest magnitude.
    #[inline(always)]
    pub fn magnitude(self) -> f64 {
        let Self([x, y, z, w]) = self;
        let Self([xz, yw, ..]) = Self([x, y, 0.0, 0.0]).largest(Self([z, w, 0.0, 0.0]));
        if xz > yw { xz } else { yw }
    }
}
