use super::deviation::Deviation;
use super::exact_motion::ExactMotion;
use crate::propagation::{PreciseState, PropagationError, States};
use crate::scenario::{Certificate, Grid, Path, Plan, PlannedBody};

/// Samples compared at most.
const MOST_SAMPLES: u64 = 1000;

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

/// The same of one body, at the samples of `grid`.
///
/// # Errors
/// As [`certify`].
pub fn certify_body(body: &PlannedBody, grid: &Grid) -> Result<Certificate, PropagationError> {
    let mut indices = Grid::spread(grid.len(), MOST_SAMPLES);
    let exact_at = |indices: &[u64]| {
        let times = indices.iter().map(|index| grid.time(*index));
        ExactMotion::at(&body.problem, times, ExactMotion::MOST_STEPS)
    };
    let mut exact = exact_at(&indices)?;
    let is_whole = exact.states.len() == indices.len();
    if !is_whole {
        // As many samples again, from the part that is within reach.
        indices = Grid::spread(samples_until(grid, exact.reached), MOST_SAMPLES);
        exact = exact_at(&indices)?;
    }
    let ExactMotion { states, uncertainty, .. } = exact;
    let exact: Vec<(u64, PreciseState)> = indices.into_iter().zip(states).collect();
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
        reference: ExactMotion::NAME.to_owned(),
        reference_uncertainty: uncertainty,
    })
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
