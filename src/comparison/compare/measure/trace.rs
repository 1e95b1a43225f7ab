/// How a difference went over time: its largest in each of some thousand stretches, whatever the number of samples.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trace {
    stretches: Vec<Stretch>,
    /// Samples in a stretch; 0 before the first.
    stride: u64,
    /// Samples in the last stretch.
    last: u64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Stretch {
    time_s: f64,
    largest: f64,
}

impl Trace {
    /// Stretches at most.
    pub const MOST: usize = 4096;

    /// When each stretch has its largest difference (ascending, s), and that.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.stretches.iter().map(|stretch| (stretch.time_s, stretch.largest))
    }

    /// Goes on by one sample.
    pub fn push(&mut self, time_s: f64, difference: f64) {
        if self.last == self.stride {
            self.begin(time_s, difference);
            return;
        }
        self.last += 1;
        if let Some(stretch) = self.stretches.last_mut().filter(|stretch| difference > stretch.largest) {
            *stretch = Stretch { time_s, largest: difference };
        }
    }

    fn begin(&mut self, time_s: f64, largest: f64) {
        if self.stretches.len() == Self::MOST {
            self.halve();
        }
        self.stride = self.stride.max(1);
        self.stretches.push(Stretch { time_s, largest });
        self.last = 1;
    }

    /// Two stretches each become one.
    fn halve(&mut self) {
        let larger = |pair: &[Stretch]| match pair {
            [one, other] if other.largest > one.largest => *other,
            [one, ..] => *one,
            [] => Stretch { time_s: 0.0, largest: 0.0 },
        };
        self.stretches = self.stretches.chunks(2).map(larger).collect();
        self.stride *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_largest_is_kept_at_its_time() {
        let mut trace = Trace::default();
        let difference = |index: u32| if index == 77_777 { 9.0 } else { f64::from(index % 10) / 10.0 };
        for index in 0..100_000 {
            trace.push(f64::from(index), difference(index));
        }
        let points: Vec<_> = trace.points().collect();
        assert!((Trace::MOST / 2..=Trace::MOST).contains(&points.len()), "{}", points.len());
        assert!(points.contains(&(77_777.0, 9.0)));
        assert!(points.iter().all(|(_, largest)| *largest >= 0.9));
        assert!(points.is_sorted_by(|one, next| one.0 < next.0));
    }
}
