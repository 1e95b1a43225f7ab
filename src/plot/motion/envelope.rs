/// A column of numbers against time in flat memory, thinned so that no peak is lost: of each stretch of samples the first,
/// the last, the least and the greatest are kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelope {
    stretches: Vec<Stretch>,
    /// Samples in a stretch; the last one may have fewer.
    each: u64,
    in_last: u64,
}

/// Times and values.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stretch {
    first: [f64; 2],
    least: [f64; 2],
    greatest: [f64; 2],
    last: [f64; 2],
}

impl Default for Envelope {
    fn default() -> Self {
        Self { stretches: Vec::new(), each: 1, in_last: 0 }
    }
}

impl Envelope {
    /// Stretches at most: more than a sheet has pixels from side to side.
    const MOST: usize = 2048;

    /// The next sample. What is no number is left out.
    pub fn push(&mut self, time_s: f64, value: f64) {
        if !value.is_finite() {
            return;
        }
        let point = [time_s, value];
        let one = Stretch { first: point, least: point, greatest: point, last: point };
        if self.in_last < self.each
            && let Some(last) = self.stretches.last_mut()
        {
            *last = last.and(&one);
            self.in_last += 1;
            return;
        }
        if self.stretches.len() == Self::MOST {
            self.stretches = merged(&self.stretches, 2);
            self.each *= 2;
        }
        self.stretches.push(one);
        self.in_last = 1;
    }

    /// Points of a curve on so many columns of pixels, times ascending.
    #[must_use]
    pub fn points(&self, columns: usize) -> Vec<[f64; 2]> {
        let together = self.stretches.len().div_ceil(columns.max(1)).max(1);
        let mut points = Vec::new();
        for stretch in merged(&self.stretches, together) {
            let Stretch { first, least, greatest, last } = stretch;
            let between = if least[0] <= greatest[0] { [least, greatest] } else { [greatest, least] };
            for point in [first, between[0], between[1], last] {
                if points.last() != Some(&point) {
                    points.push(point);
                }
            }
        }
        points
    }

    /// The least and the greatest value, if there is any.
    #[must_use]
    pub fn range(&self) -> Option<(f64, f64)> {
        let all = self.stretches.iter().copied().reduce(|all, next| all.and(&next))?;
        Some((all.least[1], all.greatest[1]))
    }
}

impl Stretch {
    fn and(&self, next: &Self) -> Self {
        let least = if next.least[1] < self.least[1] { next.least } else { self.least };
        let greatest = if next.greatest[1] > self.greatest[1] { next.greatest } else { self.greatest };
        Self { first: self.first, least, greatest, last: next.last }
    }
}

fn merged(stretches: &[Stretch], together: usize) -> Vec<Stretch> {
    let groups = stretches.chunks(together);
    groups.filter_map(|group| group.iter().copied().reduce(|all, next| all.and(&next))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_samples_are_kept_as_they_are() {
        let mut envelope = Envelope::default();
        let samples: Vec<_> = (0..500).map(|index| [f64::from(index), f64::from(index * index % 17)]).collect();
        for [time, value] in &samples {
            envelope.push(*time, *value);
        }
        assert_eq!(envelope.points(1000), samples);
    }

    #[test]
    fn a_peak_of_one_sample_in_a_million_is_kept() {
        let mut envelope = Envelope::default();
        for index in 0..1_000_000 {
            envelope.push(f64::from(index), if index == 123_456 { 7.0 } else { 1e-3 * f64::from(index % 2) });
        }
        let points = envelope.points(500);
        assert!(points.contains(&[123_456.0, 7.0]));
        assert!(points.len() <= 4 * 500, "{}", points.len());
        assert!(points.windows(2).all(|pair| pair[0][0] <= pair[1][0]), "times ascend");
        assert_eq!((points[0], points[points.len() - 1]), ([0.0, 0.0], [999_999.0, 1e-3]));
        assert_eq!(envelope.range(), Some((0.0, 7.0)));
    }
}
