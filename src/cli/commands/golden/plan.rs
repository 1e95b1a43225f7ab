use super::error::GoldenError;
use crate::cli::execute::scenario;
use crate::scenario::{Grid, Plan};
use crate::telemetry::Channel;

/// Numbers in a golden's columns, about: with as many, columns are small beside the words that any recording holds.
const NUMBERS: usize = 800;
/// Fewer samples tell too little of a motion.
const FEWEST: usize = 16;
/// More tell nothing new where every bit must be the same.
const MOST: usize = 50;
/// Channels of all bodies together: each is an entity of an `.rrd`, 2 to 3 kB.
const CHANNELS: usize = 48;

/// The plan of a golden, its checks measured: the scene `name` at every k-th of its sample times and, if it has many bodies,
/// with fewer channels. It is the scene with keys overridden, so that `polhode run --set` gives the same.
///
/// # Errors
/// If the scene cannot be read, planned or run.
pub fn plan(name: &str) -> Result<Plan, GoldenError> {
    let whole = Plan::new(&scenario(name, &[])?)?;
    let channels = channels(&whole);
    let times = times(&whole, channels.as_deref());
    let assignments: Vec<_> = times.into_iter().chain(channels.as_deref().map(named)).collect();
    Ok(Plan::new(&scenario(name, &assignments)?)?.checked()?)
}

/// What thins the samples of `plan`, as an assignment, if there are too many.
fn times(plan: &Plan, channels: Option<&[Channel]>) -> Option<String> {
    let recorded = plan.bodies.iter().flat_map(|body| channels.unwrap_or(&body.channels));
    let of_points = plan.bodies.iter().flat_map(|body| &body.points).flat_map(|point| &point.channels);
    let columns = 1 + recorded.chain(of_points).map(|channel| channel.width()).sum::<usize>();
    let most = (NUMBERS / columns).clamp(FEWEST, MOST);
    let stride = plan.grid.len().saturating_sub(1).div_ceil(most as u64);
    (stride > 1).then(|| match &plan.grid {
        Grid::Uniform { .. } => format!("sample_every_s={:?}", short(plan.grid.time(stride))),
        Grid::List(times) => {
            let stride = usize::try_from(stride).unwrap_or(usize::MAX);
            format!("sample_times_s={:?}", times.iter().step_by(stride).collect::<Vec<_>>())
        }
    })
}

/// Without the rounding of a product: 140 times 0.005 s is 0.7 s.
fn short(time_s: f64) -> f64 {
    format!("{time_s:.11e}").parse().unwrap_or(time_s)
}

/// The first of the channels that all bodies have, if all of them are too many.
fn channels(plan: &Plan) -> Option<Vec<Channel>> {
    let count: usize = plan.bodies.iter().map(|body| body.channels.len()).sum();
    if count <= CHANNELS {
        return None;
    }
    let is_shared = |channel: &Channel| plan.bodies.iter().all(|body| body.channels.contains(channel));
    let each = (CHANNELS / plan.bodies.len()).max(1);
    Some(Channel::ALL.into_iter().filter(is_shared).take(each).collect())
}

/// As an assignment.
fn named(channels: &[Channel]) -> String {
    format!("channels={:?}", channels.iter().map(|channel| channel.row().name).collect::<Vec<_>>())
}
