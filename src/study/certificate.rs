use super::deviation::{Deviation, angle, distance, length};
use crate::propagation::{PreciseState, PreciseTaylor, PropagationError, States};
use crate::scenario::{Certificate, Grid, Path, Plan, PlannedBody};

/// Samples compared at most.
const MOST_SAMPLES: u64 = 1000;
/// Steps of the reference at most, for each body: about a thousand turns.
const MOST_STEPS: u64 = 20_000;
/// Of the second run of the reference: other steps, so other rounding.
const OTHER_TOLERANCE: f64 = 1e-30;
/// How far the two runs may differ, rad and relative in ω: far below one rounding in f64.
const TRUSTED: f64 = 1e-18;
/// As certificates call it.
const REFERENCE: &str = "Taylor series in double-double";

/// Measures the error of each body's path, against the same motion in double-double.
///
/// Up to 1000 of the run's own samples are compared, the first and the last among them. The reference is run twice, by
/// different steps, 20,000 at most. A run is certified as far as these reach and agree to 1e-18, and its certificate says
/// how far that is: near a separatrix, where differences grow without end, 106 bits do not last for ever. Nothing depends
/// on the clock: the same plan has the same certificates.
///
/// # Errors
/// If a path or the reference cannot propagate the motion.
pub fn certify(plan: &Plan) -> Result<Vec<Certificate>, PropagationError> {
    plan.bodies.iter().map(|body| certify_body(body, &plan.grid)).collect()
}

fn certify_body(body: &PlannedBody, grid: &Grid) -> Result<Certificate, PropagationError> {
    let mut count = grid.len();
    let mut exact = ExactMotion::of(body, grid, count)?;
    let is_whole = exact.states.last().is_some_and(|(index, _)| index + 1 == count);
    if !is_whole {
        // As many samples again, from the part that is within reach.
        count = samples_until(grid, exact.reached);
        exact = ExactMotion::of(body, grid, count)?;
    }
    let ExactMotion { states: exact, uncertainty, .. } = exact;
    let mut deviation = Deviation::new(body);
    compare(body, grid, &exact, &mut deviation)?;
    let last = exact.last().map_or(0, |(index, _)| *index);
    Ok(Certificate {
        attitude_rad: body.problem.wants_attitude.then_some(deviation.attitude()),
        angular_velocity_relative: deviation.angular_velocity(),
        angular_momentum_relative: body.problem.wants_attitude.then_some(deviation.angular_momentum()),
        position_m: body.problem.wants_translation.then_some(deviation.position()),
        worst_at_s: deviation.worst_at(),
        covered_to_s: grid.time(last),
        is_whole,
        samples: exact.len(),
        method: body.path.name().to_owned(),
        reference: REFERENCE.to_owned(),
        reference_uncertainty: uncertainty,
    })
}

/// The motion at some samples, as far as the reference reaches.
struct ExactMotion {
    /// Sample numbers, and the states there.
    states: Vec<(u64, PreciseState)>,
    /// How far that is, s.
    reached: f64,
    /// The largest difference between two runs of the reference, rad or relative in ω.
    uncertainty: f64,
}

impl ExactMotion {
    /// At samples spread over the first `count`.
    fn of(body: &PlannedBody, grid: &Grid, count: u64) -> Result<Self, PropagationError> {
        let mut reference = PreciseTaylor::new(&body.problem)?.limited_to(MOST_STEPS);
        let mut other = reference.clone().with_tolerance(OTHER_TOLERANCE);
        let mut exact = Self { states: Vec::new(), reached: 0.0, uncertainty: 0.0 };
        let mut fastest = 0.0_f64;
        for index in spread(count) {
            let time = grid.time(index);
            let (Some(state), Some(again)) = (reference.at(time)?, other.at(time)?) else {
                exact.reached = reference.reached().min(other.reached());
                break;
            };
            fastest = length(state.angular_velocity).max(fastest);
            let apart = difference(&state, &again, fastest);
            if apart > TRUSTED {
                break;
            }
            exact.uncertainty = exact.uncertainty.max(apart);
            exact.reached = time;
            exact.states.push((index, state));
        }
        Ok(exact)
    }
}

/// Of attitudes in rad, or of ω relative to the fastest so far, as a body may come to rest; the larger.
fn difference(a: &PreciseState, b: &PreciseState, fastest: f64) -> f64 {
    let omega = distance(a.angular_velocity, b.angular_velocity);
    angle(a.attitude, b.attitude).max(if omega > 0.0 { omega / fastest } else { 0.0 })
}

/// At most [`MOST_SAMPLES`] of the numbers 0 … count − 1, both ends among them.
fn spread(count: u64) -> Vec<u64> {
    if count <= MOST_SAMPLES {
        return (0..count).collect();
    }
    (0..MOST_SAMPLES).map(|n| n * (count - 1) / (MOST_SAMPLES - 1)).collect()
}

/// How many samples are at or before `time`; times ascend.
fn samples_until(grid: &Grid, time: f64) -> u64 {
    let (mut low, mut high) = (0, grid.len());
    while low < high {
        let middle = low + (high - low) / 2;
        if grid.time(middle) <= time { low = middle + 1 } else { high = middle }
    }
    low
}

/// Runs the body's own path past the samples compared.
fn compare(
    body: &PlannedBody,
    grid: &Grid,
    exact: &[(u64, PreciseState)],
    deviation: &mut Deviation,
) -> Result<(), PropagationError> {
    let last = exact.last().map_or(0, |(index, _)| *index);
    let indices: Vec<u64> = match body.path {
        // Its steps end on every sample, so that it has to see them all to make the same ones.
        Path::FixedStep { .. } => (0..=last).collect(),
        _ => exact.iter().map(|(index, _)| *index).collect(),
    };
    let mut path = body.propagator()?;
    let (mut states, mut exact) = (States::default(), exact.iter().peekable());
    for indices in indices.chunks(Plan::BATCH) {
        let times: Vec<f64> = indices.iter().map(|index| grid.time(*index)).collect();
        path.fill(&times, &mut states)?;
        for (row, index) in indices.iter().enumerate() {
            if let Some((_, exact)) = exact.next_if(|(wanted, _)| wanted == index) {
                deviation.include(times[row], &states, row, exact);
            }
        }
    }
    Ok(())
}
