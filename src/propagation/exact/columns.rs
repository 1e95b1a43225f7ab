use crate::propagation::States;

/// A closed form, one time at a time. No branches that depend on `time`: the loops below are to become vector code.
pub trait Motion {
    /// The principal axis that each of the three rates belongs to.
    fn axes(&self) -> [usize; 3];

    /// Rates about [`Self::axes`], rad/s.
    fn rates(&self, time: f64) -> [f64; 3];

    /// The same, bit for bit, and the attitude w, x, y, z.
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]);
}

/// Samples worked on side by side.
const LANES: usize = 8;

/// Fills the columns of ω, as long as `times`.
pub fn fill_rates<M: Motion>(motion: &M, times: &[f64], states: &mut States) {
    let axes = motion.axes();
    for (block, times) in times.chunks(LANES).enumerate() {
        let mut rates = [[0.0; LANES]; 3];
        let lanes = padded(times);
        for lane in 0..LANES {
            let [a, b, c] = motion.rates(lanes[lane]);
            (rates[0][lane], rates[1][lane], rates[2][lane]) = (a, b, c);
        }
        copy(&rates, block, times.len(), |k| axes[k], &mut states.angular_velocity);
    }
}

/// Fills the columns of ω and of the attitude, as long as `times`.
pub fn fill_rates_and_attitude<M: Motion>(motion: &M, times: &[f64], states: &mut States) {
    let axes = motion.axes();
    for (block, times) in times.chunks(LANES).enumerate() {
        let (mut rates, mut attitude) = ([[0.0; LANES]; 3], [[0.0; LANES]; 4]);
        let lanes = padded(times);
        for lane in 0..LANES {
            let ([a, b, c], [w, x, y, z]) = motion.rates_and_attitude(lanes[lane]);
            (rates[0][lane], rates[1][lane], rates[2][lane]) = (a, b, c);
            (attitude[0][lane], attitude[1][lane], attitude[2][lane], attitude[3][lane]) = (w, x, y, z);
        }
        copy(&rates, block, times.len(), |k| axes[k], &mut states.angular_velocity);
        copy(&attitude, block, times.len(), |k| k, &mut states.attitude);
    }
}

/// A whole block of times; a short last one is filled up with zeros.
fn padded(times: &[f64]) -> [f64; LANES] {
    let mut lanes = [0.0; LANES];
    lanes[..times.len()].copy_from_slice(times);
    lanes
}

fn copy<const N: usize>(
    from: &[[f64; LANES]; N],
    block: usize,
    count: usize,
    column: impl Fn(usize) -> usize,
    to: &mut [Vec<f64>; N],
) {
    let start = block * LANES;
    for (k, values) in from.iter().enumerate() {
        to[column(k)][start..start + count].copy_from_slice(&values[..count]);
    }
}
