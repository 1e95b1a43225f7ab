use crate::recording::{Axes, Track};

/// Up to here a whole number of ns is exact as an f64: a hundred days.
const EXACT_NS: u64 = 1 << 53;

/// What to take off stamps in ns so that they become seconds without loss: nothing, unless they are those of an absolute
/// clock.
pub(in crate::recording) fn start_of(first_ns: i64) -> i64 {
    if first_ns.unsigned_abs() < EXACT_NS { 0 } else { first_ns }
}

/// ns since `start_ns` in s, rounded to the nearest.
#[expect(clippy::cast_precision_loss, reason = "exact in a recording shorter than a hundred days")]
pub(in crate::recording) fn seconds(stamp_ns: i64, start_ns: i64) -> f64 {
    (i128::from(stamp_ns) - i128::from(start_ns)) as f64 / 1e9
}

/// A quantity as messages tell it.
#[derive(Debug)]
pub(super) struct Stamped<const N: usize> {
    /// As the messages say.
    stamps: Vec<i64>,
    /// As they were recorded.
    logged: Vec<i64>,
    columns: [Vec<f64>; N],
}

impl<const N: usize> Default for Stamped<N> {
    fn default() -> Self {
        Self { stamps: Vec::new(), logged: Vec::new(), columns: std::array::from_fn(|_| Vec::new()) }
    }
}

impl<const N: usize> Stamped<N> {
    /// Takes a value in, unless it is what was said before of the same time.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn push(&mut self, stamp_ns: i64, log_ns: i64, values: [f64; N]) -> Result<(), &'static str> {
        if !values.iter().all(|value| value.is_finite()) {
            return Err("is not finite");
        }
        let is_repeated = stamp_ns != 0
            && self.stamps.last() == Some(&stamp_ns)
            && self.columns.iter().zip(&values).all(|(column, value)| column.last() == Some(value));
        if !is_repeated {
            self.stamps.push(stamp_ns);
            self.logged.push(log_ns);
            self.columns.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        }
        Ok(())
    }

    pub fn len(&self) -> usize {
        self.stamps.len()
    }

    pub fn columns_mut(&mut self) -> &mut [Vec<f64>; N] {
        &mut self.columns
    }

    /// Its own stamps, or when it was recorded if it has none.
    pub fn stamps(&self) -> &[i64] {
        if self.stamps.iter().all(|stamp| *stamp == 0) { &self.logged } else { &self.stamps }
    }

    /// Over time from `start_ns`.
    ///
    /// # Errors
    /// Which time does not come after the one before, or is too far from the start for an f64 to tell it from that.
    pub fn into_track(self, start_ns: i64, axes: Option<Axes>, resolution: f64) -> Result<Track<N>, String> {
        if let Some([last, next]) = self.stamps().array_windows().find(|[last, next]| next <= last) {
            return Err(format!("is told at {next} ns after {last} ns: times ascend"));
        }
        let times_s: Vec<f64> = self.stamps().iter().map(|stamp| seconds(*stamp, start_ns)).collect();
        if let Some(index) = times_s.array_windows().position(|[last, next]| next <= last) {
            let (last, next) = (self.stamps()[index], self.stamps()[index + 1]);
            return Err(format!(
                "is told at {next} ns after {last} ns: so long after the start of the file, at {start_ns} ns, both are one f64 of \
                 seconds"
            ));
        }
        Ok(Track { times_s, columns: self.columns, axes, resolution })
    }
}
