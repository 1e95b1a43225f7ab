use crate::propagation::PropagationError;
use crate::scenario::PlannedBody;
use crate::telemetry::Channel;

/// Times at which a search looks in every bracket.
const LOOKS: usize = 64;

/// Twice the time between sign changes of ω along the middle principal axis, the period of the polhode, s; NaN if three
/// do not come within three expected periods.
pub fn flip_period(body: &PlannedBody, expected: f64) -> Result<f64, PropagationError> {
    let middle = middle_axis(body);
    let middle_rate = |times: &[f64]| -> Result<Vec<f64>, PropagationError> {
        let rates = body.sample(&[Channel::AngularVelocity], times)?;
        let turn = body.properties.body_from_principal;
        let columns = rates.columns();
        let along = |index: usize| {
            let in_body = nalgebra::Vector3::from_fn(|row, _| columns[row][index]);
            turn.inverse_transform_vector(&in_body)[middle]
        };
        Ok((0..times.len()).map(along).collect())
    };
    let mut brackets = sign_changes(&evenly(0.0, 3.2 * expected, 64 * LOOKS), &middle_rate)?;
    if brackets.len() < 3 {
        return Ok(f64::NAN);
    }
    brackets.truncate(3);
    // Each round narrows every bracket 64-fold, all of them in one ascending pass: propagators do not go back.
    for _ in 0..6 {
        let times: Vec<f64> = brackets.iter().flat_map(|(from, to)| evenly(*from, *to, LOOKS)).collect();
        let narrower = sign_changes(&times, &middle_rate)?;
        if narrower.len() != 3 {
            break;
        }
        brackets = narrower;
    }
    let middle_of = |(from, to): (f64, f64)| 0.5 * (from + to);
    Ok(middle_of(brackets[2]) - middle_of(brackets[0]))
}

/// Which principal axis has the middle moment.
fn middle_axis(body: &PlannedBody) -> usize {
    let moments = body.properties.moments.vector();
    let mut axes = [0, 1, 2];
    axes.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    axes[1]
}

/// Neighbouring times between which the values change sign.
fn sign_changes(
    times: &[f64],
    values: &impl Fn(&[f64]) -> Result<Vec<f64>, PropagationError>,
) -> Result<Vec<(f64, f64)>, PropagationError> {
    let values = values(times)?;
    let changes = times.windows(2).zip(values.windows(2)).filter(|(_, value)| (value[0] < 0.0) != (value[1] < 0.0));
    Ok(changes.map(|(time, _)| (time[0], time[1])).collect())
}

/// `count + 1` times from `from` to `to`, ends included.
#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
pub fn evenly(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|index| from + (to - from) * (index as f64 / count as f64)).collect()
}
