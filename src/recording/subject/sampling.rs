use crate::recording::picture::pace;
use crate::scenario::Grid;

/// How many samples, and when: as much as is known of it before the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// How many.
    pub samples: u64,
    /// Time of the first, s.
    pub from_s: f64,
    /// Time of the last, s.
    pub to_s: f64,
    /// The interval, s, if sample n is at n times it, rounded once; `None` where each has its own time.
    pub interval_s: Option<f64>,
}

impl Sampling {
    /// That of a plan.
    #[must_use]
    pub fn of(grid: &Grid) -> Self {
        let interval_s = match grid {
            Grid::Uniform { every_s, .. } => Some(*every_s),
            Grid::List(_) => None,
        };
        Self { samples: grid.len(), from_s: grid.time(0), to_s: grid.end(), interval_s }
    }

    /// Seconds of motion in a second of playback.
    #[must_use]
    pub fn playback_speed(self) -> f64 {
        pace::playback_speed(self.to_s - self.from_s)
    }
}
