use super::invariants::{Polhode, Start};
use super::polhode_rates::Periods;
use crate::numerics::{DoubleDouble, carlson_rf};

/// The times at which ω along the middle axis changes sign, where each of three moments is another: an arithmetic
/// progression, or one time on the separatrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reversals {
    /// One of the times, s, the nearest to t = 0 or next to it; it may be negative.
    pub at: f64,
    /// From one to the next, s; infinite on the separatrix.
    pub interval: f64,
    /// How near L comes to the middle axis between them, in the body: the cosine of the angle.
    pub nearness: f64,
}

impl Reversals {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub(super) fn new(start: &Start, polhode: &Polhode, scale: f64) -> Self {
        let u0 = polhode.sn * carlson_rf(polhode.cn_squared, polhode.dn_squared, DoubleDouble::ONE);
        let rate = polhode.rate.scale(1.0 / scale);
        // sn is zero at every 2K.
        let interval = if polhode.complement.is_zero() {
            f64::INFINITY
        } else {
            let (Periods::Far { k, .. } | Periods::Near { k, .. }) = Periods::new(polhode);
            (k.scale(2.0) / rate).hi()
        };
        let along = polhode.amplitudes[1] * start.moments[1];
        Self { at: -(u0 / rate).hi(), interval, nearness: (along / polhode.momentum_size).hi().abs() }
    }

    /// The times after 0 and up to `end`, s, ascending.
    pub fn until(self, end: f64) -> impl Iterator<Item = f64> {
        let first = if self.at > 0.0 { self.at } else { self.at + self.interval };
        // By multiplication: a sum would round at each.
        let nth = move |number: u32| if number == 0 { first } else { first + f64::from(number) * self.interval };
        (0..u32::MAX).map(nth).take_while(move |time| *time <= end)
    }
}
