use crate::numerics::vectorised;
use crate::propagation::States;

/// ω in closed form, one time at a time. No branches that depend on `time` and everything inlined: the loops below are to
/// become vector code.
pub trait Rates {
    /// The principal axis that each of the three rates belongs to.
    fn axes(&self) -> [usize; 3];

    /// Rates about [`Self::axes`], rad/s.
    fn rates(&self, time: f64) -> [f64; 3];
}

/// The attitude, too.
pub trait Motion: Rates {
    /// [`Rates::rates`], bit for bit, and the attitude w, x, y, z.
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]);
}

/// Samples worked on side by side.
const LANES: usize = 4;

/// A quantity's values in all lanes.
type Lanes = [f64; LANES];

/// Fills the columns of ω, and those of the attitude where wanted: as long as `times`.
pub fn fill_columns<M: Motion>(motion: &M, times: &[f64], wants_attitude: bool, states: &mut States) {
    if wants_attitude {
        vectorised(
            #[inline(always)]
            || fill_rates_and_attitude(motion, times, states),
        );
    } else {
        fill_rates(motion, times, states);
    }
}

/// Fills the columns of ω, as long as `times`.
pub fn fill_rates<R: Rates>(motion: &R, times: &[f64], states: &mut States) {
    vectorised(
        #[inline(always)]
        || fill_blocks_of_rates(motion, times, states),
    );
}

#[inline(always)]
fn fill_blocks_of_rates<R: Rates>(motion: &R, times: &[f64], states: &mut States) {
    let axes = motion.axes();
    for (block, times) in times.chunks(LANES).enumerate() {
        let mut rates = [[0.0; LANES]; 3];
        let lanes = padded(times);
        for lane in 0..LANES {
            let [a, b, c] = motion.rates(lanes[lane]);
            (rates[0][lane], rates[1][lane], rates[2][lane]) = (a, b, c);
        }
        copy(&rates, block, times.len(), axes, &mut states.angular_velocity);
    }
}

#[inline(always)]
fn fill_rates_and_attitude<M: Motion>(motion: &M, times: &[f64], states: &mut States) {
    let axes = motion.axes();
    for (block, times) in times.chunks(LANES).enumerate() {
        let (mut rates, mut attitude) = ([[0.0; LANES]; 3], [[0.0; LANES]; 4]);
        let lanes = padded(times);
        for lane in 0..LANES {
            let ([a, b, c], [w, x, y, z]) = motion.rates_and_attitude(lanes[lane]);
            (rates[0][lane], rates[1][lane], rates[2][lane]) = (a, b, c);
            (attitude[0][lane], attitude[1][lane], attitude[2][lane], attitude[3][lane]) = (w, x, y, z);
        }
        copy(&rates, block, times.len(), axes, &mut states.angular_velocity);
        copy(&attitude, block, times.len(), [0, 1, 2, 3], &mut states.attitude);
    }
}

/// A whole block of times; a short last one is filled up with zeros.
#[inline(always)]
fn padded(times: &[f64]) -> Lanes {
    Lanes::try_from(times).unwrap_or_else(|_| {
        let mut lanes = [0.0; LANES];
        lanes[..times.len()].copy_from_slice(times);
        lanes
    })
}

#[inline(always)]
fn copy<const N: usize>(from: &[Lanes; N], block: usize, count: usize, columns: [usize; N], to: &mut [Vec<f64>; N]) {
    let start = block * LANES;
    for k in 0..N {
        // A length known beforehand is a few vector moves; any other is a call.
        let column = &mut to[columns[k]][start..start + count];
        if let Ok(whole) = <&mut Lanes>::try_from(&mut *column) {
            *whole = from[k];
        } else {
            column.copy_from_slice(&from[k][..count]);
        }
    }
}
