use crate::propagation::PropagationError;
use crate::scenario::PlannedBody;
use crate::telemetry::Channel;

/// Times at which a search looks in every bracket.
const LOOKS: usize = 64;

/// Twice the time between sign changes of ω along the middle principal axis, the period of the polhode, s; NaN if three
/// do not come within three expected periods.
pub fn flip_period(body: &PlannedBody, expected: f64) -> Result<f64, PropagationError> {
    Ok(flips(body, expected)?.map_or(f64::NAN, |[first, third]| third - first))
}

/// The times, s, of the first sign change of ω along the middle principal axis and of the next but one, if they come within
/// three expected periods.
pub fn flips(body: &PlannedBody, expected: f64) -> Result<Option<[f64; 2]>, PropagationError> {
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
        return Ok(None);
    }
    brackets.truncate(3);
    let times = narrowed(brackets, &middle_rate)?;
    Ok(Some([times[0], times[2]]))
}

/// What of a bracket's time it may be wide by, for its middle to be where the sign changes.
const NARROW: f64 = 1e-12;

/// The middles of brackets around sign changes of `values`, up and down in turn, once they are as narrow as they get; NaN
/// where one holds several.
///
/// Each round narrows every bracket 64-fold, all of them in one ascending pass: propagators do not go back.
pub fn narrowed(
    mut brackets: Vec<(f64, f64)>,
    values: &impl Fn(&[f64]) -> Result<Vec<f64>, PropagationError>,
) -> Result<Vec<f64>, PropagationError> {
    for _ in 0..9 {
        let times: Vec<f64> = brackets.iter().flat_map(|(from, to)| evenly(*from, *to, LOOKS)).collect();
        let narrower = sign_changes(&times, values)?;
        if narrower.len() != brackets.len() {
            break;
        }
        brackets = narrower;
    }
    let middle = |(from, to): (f64, f64)| if to - from <= NARROW * to { 0.5 * (from + to) } else { f64::NAN };
    Ok(brackets.into_iter().map(middle).collect())
}

/// Which principal axis has the middle moment.
fn middle_axis(body: &PlannedBody) -> usize {
    let moments = body.properties.moments.vector();
    let mut axes = [0, 1, 2];
    axes.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    axes[1]
}

/// Neighbouring times between which the values change sign.
pub fn sign_changes(
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
