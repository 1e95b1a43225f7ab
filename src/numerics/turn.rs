use super::DoubleDouble;
use super::double_double::{two_prod, two_sum};
use super::elementary::polynomial;

/// An angle that grows evenly with time, in **turns** (of 2π), kept in double-double.
///
/// Turns rather than radians, so that whole ones come off exactly: however many there have been, what is left is right
/// to the last bits of the rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// At t = 0, turns.
    pub start: DoubleDouble,
    /// Turns per second.
    pub rate: DoubleDouble,
}

/// What is left of an angle without its whole turns: `hi + lo`, between −½ and ½.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    hi: f64,
    lo: f64,
}

impl Phase {
    /// The angle at `time`, whole turns taken off.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, time: f64) -> Turn {
        let (turned, error) = two_prod(self.rate.hi(), time);
        let (angle, lost) = two_sum(turned, self.start.hi());
        let low = ((self.rate.lo() * time + error) + self.start.lo()) + lost;
        // Twice: from 2⁵² turns on the first rounding leaves more than half a turn in `low`.
        let left = angle - round(angle);
        let (hi, lo) = two_sum(left, low);
        let (hi, lo) = two_sum(hi - round(hi), lo);
        Turn { hi, lo }
    }
}

impl Turn {
    /// Nearest f64 to the angle, turns.
    #[inline(always)]
    #[must_use]
    pub fn turns(self) -> f64 {
        self.hi
    }

    /// The angle as (half turn taken off?, rest between −¼ and ¼ turns).
    #[inline(always)]
    #[must_use]
    pub fn without_half_turn(self) -> (bool, f64) {
        let halves = round(2.0 * self.hi);
        (halves != 0.0, (self.hi - 0.5 * halves) + self.lo)
    }

    /// The angle turned further by a small one, turns.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, turns: f64) -> Self {
        let (hi, lo) = two_sum(self.hi, turns);
        Self { hi, lo: lo + self.lo }
    }

    /// (sin, cos), each within an ulp of 1.
    #[inline(always)]
    #[must_use]
    pub fn sin_cos(self) -> (f64, f64) {
        let quarter = round(4.0 * self.hi);
        let (sin, cos) = sin_cos_of_eighth((self.hi - 0.25 * quarter) + self.lo);
        // quarter is −2 … 2, or ±3 after `plus`.
        let (odd, far) = (quarter.abs() == 1.0 || quarter.abs() == 3.0, quarter.abs() == 2.0);
        let (s, c) = if odd { (cos, sin) } else { (sin, cos) };
        let s_sign = if far || quarter == -1.0 || quarter == 3.0 { -1.0 } else { 1.0 };
        let c_sign = if far || quarter == 1.0 || quarter == -3.0 { -1.0 } else { 1.0 };
        (s_sign * s, c_sign * c)
    }
}

/// To the nearest integer for |x| < 2⁵¹, to an integer near by beyond; inlined on every target, unlike `f64::round`.
#[inline(always)]
fn round(x: f64) -> f64 {
    const MAGIC: f64 = 6_755_399_441_055_744.0; // 1.5 × 2⁵²
    (x + MAGIC) - MAGIC
}

/// (sin 2πx, cos 2πx) for |x| ≤ 1/8 and a little more, by Taylor's series: no other reduction, no table.
#[inline(always)]
fn sin_cos_of_eighth(x: f64) -> (f64, f64) {
    const TAU_LO: f64 = 2.449_293_598_294_706_4e-16;
    let y = x * x;
    let (sin_rest, cos_rest) = (polynomial(&SIN, y) * y, polynomial(&COS, y) * y);
    (std::f64::consts::TAU * x + x * (TAU_LO + sin_rest), 1.0 + cos_rest)
}

/// (−1)ᵏ (2π)²ᵏ⁺¹ / (2k+1)!, k = 1 to 8.
const SIN: [f64; 8] = [
    -41.341_702_240_399_76,
    81.605_249_276_075_06,
    -76.705_859_753_061_39,
    42.058_693_944_897_655,
    -15.094_642_576_822_99,
    3.819_952_584_848_282,
    -0.718_122_301_778_500_6,
    0.104_229_162_208_139_84,
];

/// (−1)ᵏ (2π)²ᵏ / (2k)!, k = 1 to 9.
const COS: [f64; 9] = [
    -19.739_208_802_178_716,
    64.939_394_022_668_3,
    -85.456_817_206_693_73,
    60.244_641_371_876_66,
    -26.426_256_783_374_4,
    7.903_536_371_318_469,
    -1.714_390_711_088_672,
    0.282_005_968_455_791_23,
    -0.036_382_841_142_545_67,
];
