use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// Time spent so far, from some beginning: the processor's or the wall's.
pub type Clock = fn() -> Duration;

/// What clocks on a wall show, counted from its first use.
#[must_use]
pub fn wall_clock() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}

/// Repeated times of one thing, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Half are below.
    pub median_s: f64,
    /// A quarter are below.
    pub lower_s: f64,
    /// A quarter are above.
    pub upper_s: f64,
    /// How many.
    pub count: usize,
}

impl Spread {
    /// Of at least one time.
    pub(super) fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        let at = |quarters: usize| times[(times.len() - 1) * quarters / 4];
        Self { median_s: at(2), lower_s: at(1), upper_s: at(3), count: times.len() }
    }
}

/// Fewer rounds than this have no median worth the name.
const ROUNDS_MIN: usize = 3;
const ROUNDS_MAX: usize = 51;
/// One measurement lasts at least this, s, by repeating what is shorter: far above what reading a clock costs.
const SHORTEST_S: f64 = 2e-4;

/// Times each of `works` in turn, round after round, so that a slow moment of the machine falls on all of them alike;
/// stops after `budget_s` of `clock`, but not before the third round.
pub fn interleaved(works: &mut [impl FnMut()], clock: Clock, budget_s: f64) -> Vec<Spread> {
    let repeats: Vec<u32> = works.iter_mut().map(|work| repeats(work, clock)).collect();
    let mut times = vec![Vec::new(); works.len()];
    let start = clock();
    for round in 0..ROUNDS_MAX {
        if round >= ROUNDS_MIN && clock().saturating_sub(start).as_secs_f64() > budget_s {
            break;
        }
        for ((work, repeats), times) in works.iter_mut().zip(&repeats).zip(&mut times) {
            times.push(measure(work, *repeats, clock) / f64::from(*repeats));
        }
    }
    times.into_iter().map(Spread::of).collect()
}

/// How often `work` must be repeated to last long enough; this warms it up, too.
fn repeats(work: &mut impl FnMut(), clock: Clock) -> u32 {
    let mut repeats = 1;
    while measure(work, repeats, clock) < SHORTEST_S && repeats < 1 << 20 {
        repeats *= 2;
    }
    repeats
}

fn measure(work: &mut impl FnMut(), repeats: u32, clock: Clock) -> f64 {
    let start = clock();
    for _ in 0..repeats {
        work();
    }
    clock().saturating_sub(start).as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn spread_is_median_and_quartiles() {
        let spread = Spread::of(vec![5.0, 1.0, 2.0, 4.0, 3.0]);
        assert_eq!([spread.lower_s, spread.median_s, spread.upper_s], [2.0, 3.0, 4.0]);
    }
}
