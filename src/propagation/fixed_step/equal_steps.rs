use crate::propagation::PropagationError;

/// A whole number of equal steps from one time to another, none longer than asked for; counted, not summed.
pub(super) struct EqualSteps {
    start: f64,
    /// s.
    pub length: f64,
    count: f64,
    done: f64,
}

impl EqualSteps {
    /// From `start` to a later `end`, in steps of at most `longest`, s.
    pub fn new(start: f64, end: f64, longest: f64) -> Result<Self, PropagationError> {
        // A multiple of the step that rounding put just above it is not worth a step more.
        let count = ((end - start) / longest * (1.0 - 4.0 * f64::EPSILON)).ceil().max(1.0);
        let length = (end - start) / count;
        if start + length == start {
            return Err(PropagationError::StepTooSmall { time: start, step: length });
        }
        Ok(Self { start, length, count, done: 0.0 })
    }
}

impl Iterator for EqualSteps {
    /// Where the next step starts, s.
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        if self.done >= self.count {
            return None;
        }
        // From the count, not a running sum: t = start + n h.
        let time = self.start + self.done * self.length;
        self.done += 1.0;
        Some(time)
    }
}
