use crate::recording::{Observed, Track};

/// When the samples were taken, and what is odd about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Clock {
    /// How many there are, of attitude (of ω, where there is none).
    pub samples: usize,
    /// First and last, s.
    pub span_s: [f64; 2],
    /// The median time from one to the next, s.
    pub interval_s: f64,
    /// Intervals more than half as long again as the median.
    pub gaps: usize,
    /// Times that are not after the one before; those samples are left out.
    pub not_ascending: usize,
    /// Samples that repeat the one before to the bit although the body turns; they are left out.
    pub repeated: usize,
    /// How far times are from even spacing, s, where that looks like rounding; 0 otherwise.
    pub rounding_s: f64,
}

/// A jitter below this share of the interval is taken for rounding of the times.
const ROUNDING: f64 = 0.02;

impl Clock {
    /// Of the samples that stand for the body's rotation, and which of them are used.
    pub(super) fn of(observed: &Observed, resolution_s: f64) -> (Self, Vec<usize>) {
        let (times, still): (&[f64], Vec<bool>) = match (&observed.attitude, &observed.angular_velocity) {
            (Some(attitude), rates) => (&attitude.times_s, stuck(attitude, rates.as_ref())),
            (None, Some(rates)) => (&rates.times_s, vec![false; rates.times_s.len()]),
            (None, None) => (&[], Vec::new()),
        };
        let (mut used, mut not_ascending, mut repeated) = (Vec::with_capacity(times.len()), 0, 0);
        let mut latest = f64::NEG_INFINITY;
        for (index, time) in times.iter().enumerate() {
            if !(*time > latest && time.is_finite()) {
                not_ascending += 1;
            } else if still[index] {
                repeated += 1;
            } else {
                latest = *time;
                used.push(index);
            }
        }
        let at = |k: usize| times[used[k]];
        let mut intervals: Vec<f64> = (1..used.len()).map(|k| at(k) - at(k - 1)).collect();
        let interval_s = median(&mut intervals);
        let mut uneven: Vec<f64> = (2..used.len()).map(|k| 0.5 * (at(k) - 2.0 * at(k - 1) + at(k - 2)).abs()).collect();
        let uneven = median(&mut uneven);
        let clock = Self {
            samples: times.len(),
            span_s: if used.is_empty() { [0.0; 2] } else { [at(0), at(used.len() - 1)] },
            interval_s,
            gaps: intervals.iter().filter(|interval| **interval > 1.5 * interval_s).count(),
            not_ascending,
            repeated,
            rounding_s: resolution_s.max(if uneven < ROUNDING * interval_s { uneven } else { 0.0 }),
        };
        (clock, used)
    }
}

/// Which samples are those before them, to the bit, in attitude and in rates that are not zero.
fn stuck(attitude: &Track<4>, rates: Option<&Track<3>>) -> Vec<bool> {
    let same = |columns: &[Vec<f64>], k: usize| columns.iter().all(|column| column[k] == column[k - 1]);
    let is_stuck = |k: usize| {
        let turns = match rates {
            Some(rates) if rates.times_s.len() == attitude.times_s.len() => {
                same(&rates.columns, k) && rates.columns.iter().any(|column| column[k] != 0.0)
            }
            _ => false,
        };
        turns && same(&attitude.columns, k)
    };
    (0..attitude.times_s.len()).map(|k| k > 0 && is_stuck(k)).collect()
}

/// The middle value; 0 of none. Sorts.
pub(super) fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
