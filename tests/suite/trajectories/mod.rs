//! Trajectories as hashes, one line each: every path, every branch of a closed form, every load.
//!
//! The tests compile this, and so does the small crate `tests/bits`, which other builds run.

mod planned;
mod propagated;

/// Every trajectory: its name and the hash of all its bits. One that depends on how it is asked for says so.
pub fn lines() -> Vec<String> {
    propagated::lines().into_iter().chain(planned::lines()).collect()
}

/// FNV-1a, 64 bits, of the bits of f64.
#[derive(Clone, Copy, PartialEq)]
pub struct Hash(u64);

impl Hash {
    pub const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    pub fn add(&mut self, value: f64) {
        assert!(!value.is_nan(), "the bits of a NaN are nobody's promise");
        self.add_bits(value.to_bits());
    }

    fn add_bits(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// Of several hashes, in turn.
    pub fn joined(mut self, other: Self) -> Self {
        self.add_bits(other.0);
        self
    }

    pub fn line(self, name: &str) -> String {
        format!("{:016x} {name}", self.0)
    }
}
