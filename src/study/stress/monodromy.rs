use crate::dynamics::{EulerEquations, Problem};
use crate::numerics::DoubleDouble;
use crate::propagation::{PreciseState, PreciseTaylor};
use nalgebra::Vector3;

/// The motion of a free body in double-double at any time, however late: its rates come back after a period, and each
/// period turns the body by the same rotation of the world.
///
/// Period and rotation are those of one period by Taylor series: nothing is shared with the closed form that is judged.
pub(super) struct Monodromy {
    /// At t = 0.
    start: PreciseTaylor,
    /// s.
    period: DoubleDouble,
    /// World from world, a period later.
    turn: [DoubleDouble; 4],
}

/// Turns after which one period and its powers are the cheaper reference.
const LONG: f64 = 500.0;
/// Steps of a period at most.
const MOST_STEPS: u64 = 20_000;
/// Parts of the shortest time in which a rate changes by its own size.
const PARTS: f64 = 16.0;
/// Newton's steps on the end of the period: each gains sixteen digits.
const ITERATIONS: usize = 4;
/// How nearly the rates must come back, relative.
const CLOSED: f64 = 1e-26;

impl Monodromy {
    /// As reports call it.
    pub const NAME: &str = "one period in double-double, and its powers";

    /// Of a body without loads; `None` if no period is found within 20,000 steps, or rates do not come back exactly.
    pub fn new(problem: &Problem, tolerance: f64) -> Option<Self> {
        if !problem.loads.is_empty() {
            return None;
        }
        let start = PreciseTaylor::new(problem).ok()?.with_tolerance(tolerance).limited_to(MOST_STEPS);
        let first = start.clone().at(0.0).ok()??;
        let (period, last) = period(problem, &start, &first)?;
        let turn = product(last.attitude, conjugate(first.attitude));
        Some(Self { start, period, turn })
    }

    /// The state at `time`, s.
    pub fn at(&self, time: f64) -> Option<PreciseState> {
        let count = (time / self.period.hi()).floor().max(0.0);
        let rest = DoubleDouble::from(time) - self.period * count;
        let (count, rest) = if rest.hi() < 0.0 { (count - 1.0, rest + self.period) } else { (count, rest) };
        let mut state = self.start.clone().at_exactly(rest).ok()??;
        state.attitude = unit(product(power(self.turn, count), state.attitude));
        Some(state)
    }
}

/// Whether a free body turns for so long that this is the cheaper reference.
pub(super) fn is_long(problem: &Problem, times: &[f64]) -> bool {
    let turns = problem.initial.angular_velocity.in_body().norm() * times.last().copied().unwrap_or(0.0);
    problem.loads.is_empty() && turns > LONG * std::f64::consts::TAU
}

/// When the rates come back for the first time, and the state then.
fn period(problem: &Problem, start: &PreciseTaylor, first: &PreciseState) -> Option<(DoubleDouble, PreciseState)> {
    let euler = EulerEquations::new(problem.moments);
    let change = |state: &PreciseState| euler.acceleration(&rates(state), &Vector3::zeros());
    let (omega, slope) = (rates(first), change(first));
    let size = omega.amax();
    // The component that says best when the rates are back: the one that changes fastest.
    let k = slope.iamax();
    if slope[k].abs() <= f64::EPSILON * size * size {
        // A steady spin: any period will do, a turn for one.
        let turn = DoubleDouble::from(if size > 0.0 { std::f64::consts::TAU / size } else { 1.0 });
        return (slope[k] == 0.0).then_some((turn, start.clone().at_exactly(turn).ok()??));
    }
    let part = (size / slope[k].abs()).min(1.0 / size) / PARTS;
    let (mut before, mut before_is_short) = (start.clone(), false);
    for number in 1..u32::MAX {
        let mut here = before.clone();
        let time = f64::from(number) * part;
        let state = here.at(time).ok()??;
        let is_short = (state.angular_velocity[k] - first.angular_velocity[k]).hi() * slope[k] < 0.0;
        if before_is_short && !is_short {
            let mut end = DoubleDouble::from(time);
            for _ in 0..ITERATIONS {
                let state = before.clone().at_exactly(end).ok()??;
                let short = first.angular_velocity[k] - state.angular_velocity[k];
                end += short / DoubleDouble::from(change(&state)[k]);
                if !(end.hi() > time - 2.0 * part && end.hi() < time + part) {
                    return None;
                }
                if end.hi() < time - part {
                    end = DoubleDouble::from(time - part);
                }
            }
            let last = before.clone().at_exactly(end).ok()??;
            let off = (0..3).map(|i| (last.angular_velocity[i] - first.angular_velocity[i]).hi().abs());
            if off.fold(0.0, f64::max) <= CLOSED * size {
                return Some((end, last));
            }
        }
        (before, before_is_short) = (here, is_short);
    }
    None
}

fn rates(state: &PreciseState) -> Vector3<f64> {
    Vector3::from(state.angular_velocity.map(DoubleDouble::hi))
}

fn product([a, b, c, d]: [DoubleDouble; 4], [w, x, y, z]: [DoubleDouble; 4]) -> [DoubleDouble; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

fn conjugate([w, x, y, z]: [DoubleDouble; 4]) -> [DoubleDouble; 4] {
    [w, -x, -y, -z]
}

fn unit(q: [DoubleDouble; 4]) -> [DoubleDouble; 4] {
    let factor = q.iter().fold(DoubleDouble::ZERO, |sum, component| sum + component.square()).sqrt().recip();
    q.map(|component| component * factor)
}

/// By squaring: the error of the turn grows with `count`, as it must, and no faster.
fn power(turn: [DoubleDouble; 4], mut count: f64) -> [DoubleDouble; 4] {
    let one = DoubleDouble::from(1.0);
    let (mut result, mut square) = ([one, DoubleDouble::ZERO, DoubleDouble::ZERO, DoubleDouble::ZERO], unit(turn));
    while count >= 1.0 {
        let half = (0.5 * count).floor();
        if count > 2.0 * half {
            result = unit(product(result, square));
        }
        square = unit(product(square, square));
        count = half;
    }
    result
}
