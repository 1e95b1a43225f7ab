use super::cases::{Case, Depth};
use super::truth::Truth;
use crate::scenario::{Method, Setting};

/// Steps to a turn of the fastest rate.
const QUICK_PACES: [u32; 2] = [16, 128];
const FULL_PACES: [u32; 9] = [4, 8, 16, 32, 64, 128, 256, 1024, 4096];
/// Tolerances of a step, rad; the tightest comes after them.
const QUICK_TOLERANCES: [f64; 1] = [1e-6];
const FULL_TOLERANCES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// Errors over the whole run that `auto` is asked to keep where it steps, rad.
const QUICK_PROMISES: [f64; 1] = [1e-8];
const FULL_PROMISES: [f64; 3] = [1e-4, 1e-7, 1e-10];
/// Methods with a fixed step that are run for 1e8 steps: of each family the highest order, as lower ones are lost sooner.
const LONGEST_BY: [Method; 8] = [
    Method::EulerNaive,
    Method::EulerSemiImplicit,
    Method::Rk4,
    Method::Rkmk4,
    Method::Splitting8,
    Method::Dmv8,
    Method::Gauss6,
    Method::Kicks4,
];
/// Taylor series and DOP853 at their tightest take about so many steps to a turn.
const ADAPTIVE_PACE: f64 = 16.0;

/// A setting, and how many of the truth's times it goes on by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Attempt {
    pub value: Option<f64>,
    pub stride: usize,
}

impl Attempt {
    const fn at_each_time(value: Option<f64>) -> Self {
        Self { value, stride: 1 }
    }

    /// The step near `wanted`, s, of which a whole number makes the way to the next of the times compared, or that makes
    /// the way past a whole number of them.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most the number of times")]
    fn of_step(wanted: f64, interval: f64) -> Self {
        if wanted > interval {
            let stride = (wanted / interval).round();
            return Self { value: Some(stride * interval), stride: stride as usize };
        }
        Self::at_each_time(Some(interval / (interval / wanted).ceil()))
    }
}

/// Settings to try, from coarse to fine, as far as they do not take too long.
pub(super) fn values(case: &Case, method: Method, depth: Depth, truth: &Truth) -> Vec<Attempt> {
    let span = truth.times_s.last().copied().unwrap_or(0.0);
    let turn = truth.turn_s();
    let most = exact(most_steps(case, depth));
    match method.setting() {
        Setting::None => vec![Attempt::at_each_time(None)],
        Setting::Tolerance if span / turn * ADAPTIVE_PACE > most => Vec::new(),
        // Where one number of steps is tried, one tolerance is.
        Setting::Tolerance if case.pace.is_some() => vec![Attempt::at_each_time(None)],
        Setting::Tolerance => {
            let tolerances: &[f64] = if depth == Depth::Quick { &QUICK_TOLERANCES } else { &FULL_TOLERANCES };
            tolerances.iter().copied().map(Some).chain([None]).map(Attempt::at_each_time).collect()
        }
        Setting::Step if case.pace.is_some() && depth == Depth::Full && !LONGEST_BY.contains(&method) => Vec::new(),
        Setting::Step => {
            let paces: &[u32] = match (case.pace.as_ref(), depth) {
                (Some(pace), _) => std::slice::from_ref(pace),
                (None, Depth::Quick) => &QUICK_PACES,
                (None, Depth::Full) => &FULL_PACES,
            };
            let interval = truth.times_s.get(1).copied().unwrap_or(span);
            let steps = paces.iter().map(|pace| turn / f64::from(*pace)).filter(|step| span / step <= most);
            let mut attempts: Vec<Attempt> = steps.map(|step| Attempt::of_step(step, interval)).collect();
            attempts.dedup();
            attempts
        }
    }
}

/// Errors over the whole run that `auto` is asked for, rad.
pub(super) const fn promises(depth: Depth) -> &'static [f64] {
    match depth {
        Depth::Quick => &QUICK_PROMISES,
        Depth::Full => &FULL_PROMISES,
    }
}

/// Steps of one run at most.
pub(super) fn most_steps(case: &Case, depth: Depth) -> u64 {
    match (case.pace, depth) {
        (Some(_), _) => 110_000_000,
        (None, Depth::Quick) => 6_000,
        (None, Depth::Full) => 3_000_000,
    }
}

/// A count as f64, where a rounding is nothing.
#[expect(clippy::cast_precision_loss, reason = "a bound")]
fn exact(count: u64) -> f64 {
    count as f64
}
