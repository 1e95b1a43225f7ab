use std::ops::{Add, Mul, Sub};

/// Four f64 that are worked on at once, in one register where the processor has registers so wide.
///
/// Every operation is IEEE's, component by component, none fused: the bits are the same whatever the type.
pub trait Four: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// What proves that the processor has the registers.
    type Proof: Copy;

    /// From memory.
    fn load(proof: Self::Proof, values: &[f64; 4]) -> Self;
    /// One value in all places.
    fn splat(proof: Self::Proof, value: f64) -> Self;
    /// To memory.
    fn store(self) -> [f64; 4];
    /// (1, 2, 0, 3), by places.
    #[must_use]
    fn turned(self) -> Self;
    /// (2, 0, 1, 3).
    #[must_use]
    fn turned_back(self) -> Self;
    /// (1, 0, 3, 2).
    #[must_use]
    fn swapped(self) -> Self;
    /// (2, 3, 0, 1).
    #[must_use]
    fn halves_swapped(self) -> Self;
}

/// A computation written once for every kind of register.
pub trait Kernel {
    /// What comes out.
    type Output;
    /// Must be `#[inline(always)]`, and so must what it calls: a call would leave the registers' code.
    fn run<F: Four>(self, proof: F::Proof) -> Self::Output;
}

/// Runs a kernel in the widest registers that this processor has.
#[inline]
pub fn in_registers<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if let pulp::Arch::V3(proof) = pulp::Arch::new() {
        return proof.vectorize(
            #[inline(always)]
            || kernel.run::<wide::Wide>(proof),
        );
    }
    kernel.run::<Plain>(())
}

/// Where no register is so wide.
#[derive(Debug, Clone, Copy)]
struct Plain([f64; 4]);

impl Four for Plain {
    type Proof = ();

    #[inline(always)]
    fn load((): (), values: &[f64; 4]) -> Self {
        Self(*values)
    }

    #[inline(always)]
    fn splat((): (), value: f64) -> Self {
        Self([value; 4])
    }

    #[inline(always)]
    fn store(self) -> [f64; 4] {
        self.0
    }

    #[inline(always)]
    fn turned(self) -> Self {
        let [a, b, c, d] = self.0;
        Self([b, c, a, d])
    }

    #[inline(always)]
    fn turned_back(self) -> Self {
        let [a, b, c, d] = self.0;
        Self([c, a, b, d])
    }

    #[inline(always)]
    fn swapped(self) -> Self {
        let [a, b, c, d] = self.0;
        Self([b, a, d, c])
    }

    #[inline(always)]
    fn halves_swapped(self) -> Self {
        let [a, b, c, d] = self.0;
        Self([c, d, a, b])
    }
}

macro_rules! plain {
    ($trait:ident, $method:ident, $operator:tt) => {
        impl $trait for Plain {
            type Output = Self;
            #[inline(always)]
            fn $method(self, Self(other): Self) -> Self {
                let Self([a, b, c, d]) = self;
                Self([a $operator other[0], b $operator other[1], c $operator other[2], d $operator other[3]])
            }
        }
    };
}

plain!(Add, add, +);
plain!(Sub, sub, -);
plain!(Mul, mul, *);

#[cfg(target_arch = "x86_64")]
mod wide {
    use std::arch::x86_64::__m256d;
    use std::ops::{Add, Mul, Sub};

    use pulp::bytemuck::cast;
    use pulp::x86::V3;

    use super::Four;

    /// In a register of 256 bits.
    #[derive(Debug, Clone, Copy)]
    pub struct Wide(V3, __m256d);

    impl Four for Wide {
        type Proof = V3;

        #[inline(always)]
        fn load(proof: V3, values: &[f64; 4]) -> Self {
            Self(proof, cast(*values))
        }

        #[inline(always)]
        fn splat(proof: V3, value: f64) -> Self {
            Self(proof, proof.avx._mm256_set1_pd(value))
        }

        #[inline(always)]
        fn store(self) -> [f64; 4] {
            cast(self.1)
        }

        #[inline(always)]
        fn turned(self) -> Self {
            Self(self.0, self.0.avx2._mm256_permute4x64_pd::<0b11_00_10_01>(self.1))
        }

        #[inline(always)]
        fn turned_back(self) -> Self {
            Self(self.0, self.0.avx2._mm256_permute4x64_pd::<0b11_01_00_10>(self.1))
        }

        #[inline(always)]
        fn swapped(self) -> Self {
            Self(self.0, self.0.avx._mm256_permute_pd::<0b0101>(self.1))
        }

        #[inline(always)]
        fn halves_swapped(self) -> Self {
            Self(self.0, self.0.avx._mm256_permute2f128_pd::<1>(self.1, self.1))
        }
    }

    macro_rules! wide {
        ($trait:ident, $method:ident, $operation:ident) => {
            impl $trait for Wide {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(self.0, self.0.avx.$operation(self.1, other.1))
                }
            }
        };
    }

    wide!(Add, add, _mm256_add_pd);
    wide!(Sub, sub, _mm256_sub_pd);
    wide!(Mul, mul, _mm256_mul_pd);
}

#[cfg(test)]
mod tests {
    use super::{Four, Kernel, Plain, in_registers};

    /// Every operation, on numbers that round.
    struct Everything([f64; 4], [f64; 4]);

    impl Kernel for Everything {
        type Output = [f64; 4];

        #[inline(always)]
        fn run<F: Four>(self, proof: F::Proof) -> [f64; 4] {
            let (a, b) = (F::load(proof, &self.0), F::load(proof, &self.1));
            let fused_would_differ = a * b + a.turned() * F::splat(proof, 0.1);
            (fused_would_differ.swapped() - b.halves_swapped() * a.turned_back()).store()
        }
    }

    #[test]
    fn registers_change_no_bit() {
        let (a, b) = ([0.1, -2.7, 3e-5, 1e300], [1.0 / 3.0, 7.3, -1e10, 1e-290]);
        assert_eq!(in_registers(Everything(a, b)), Everything(a, b).run::<Plain>(()));
    }

    #[test]
    fn places() {
        let four = Plain([0.0, 1.0, 2.0, 3.0]);
        assert_eq!(four.turned().store(), [1.0, 2.0, 0.0, 3.0]);
        assert_eq!(four.turned_back().store(), [2.0, 0.0, 1.0, 3.0]);
        assert_eq!(four.swapped().store(), [1.0, 0.0, 3.0, 2.0]);
        assert_eq!(four.halves_swapped().store(), [2.0, 3.0, 0.0, 1.0]);
    }
}
