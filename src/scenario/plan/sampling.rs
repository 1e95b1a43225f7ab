use super::rules::positive;
use crate::scenario::{Grid, Key, Refusal, Scenario, nanoseconds};

/// More samples than anybody can look at, and fewer than fill a disk unasked: about 300 GB.
const MOST_SAMPLES: u64 = 1_000_000_000;
/// Longest run, s: recordings stamp whole ns in 63 bits.
const LONGEST_S: f64 = 9e9;
/// Closest samples, s.
const CLOSEST_S: f64 = 1e-9;

/// The sample times that the scene asks for.
pub fn grid(scenario: &Scenario) -> Result<Grid, Refusal> {
    let duration_key = Key::root("duration_s");
    let duration = scenario.duration_s.map(|value| positive(&duration_key, value)).transpose()?;
    if let Some(duration) = duration.filter(|duration| *duration > LONGEST_S) {
        return Err(duration_key.refuse(format_args!("{duration:?} is longer than {LONGEST_S:e} s, the longest run")));
    }
    let every_key = Key::root("sample_every_s");
    match (scenario.sample_every_s, &scenario.sample_times_s) {
        (Some(_), Some(_)) => {
            Err(every_key.refuse("given beside sample_times_s: a scene has an interval or a list of times, not both"))
        }
        (None, None) => {
            Err(every_key.refuse("missing: a scene has sample_every_s, or a list of times in sample_times_s"))
        }
        (Some(every), None) => {
            let duration = duration.ok_or_else(|| duration_key.refuse("missing: sample_every_s needs it"))?;
            uniform(&every_key, duration, positive(&every_key, every)?)
        }
        (None, Some(times)) => list(times, duration),
    }
}

#[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
fn uniform(key: &Key, duration: f64, every: f64) -> Result<Grid, Refusal> {
    if every < CLOSEST_S {
        return Err(key.refuse(format_args!("{every:?} is closer than 1e-9 s: recordings stamp whole nanoseconds")));
    }
    // The last sample may be a rounding past the end: 0.3 / 0.1 is a little less than 3.
    let intervals = (duration / every * (1.0 + 4.0 * f64::EPSILON)).floor();
    if intervals >= MOST_SAMPLES as f64 {
        let rule =
            format!("{every:?} over duration_s = {duration:?} makes {intervals:e} samples: at most {MOST_SAMPLES}");
        return Err(key.refuse(rule));
    }
    if intervals < 1.0 {
        return Err(key.refuse(format_args!("{every:?} is longer than duration_s = {duration:?}")));
    }
    Ok(Grid::Uniform { every_s: every, count: intervals as u64 + 1 })
}

fn list(times: &[f64], duration: Option<f64>) -> Result<Grid, Refusal> {
    let key = Key::root("sample_times_s");
    if times.is_empty() {
        return Err(key.refuse("empty: at least one time"));
    }
    let end = duration.unwrap_or(LONGEST_S);
    for (index, time) in times.iter().enumerate() {
        if !(0.0..=end).contains(time) {
            let rule = format!("{time:?} must lie between 0 and {end} s (duration_s, or the longest run)");
            return Err(key.index(index).refuse(rule));
        }
        if index > 0 && nanoseconds(*time) <= nanoseconds(times[index - 1]) {
            let rule = format!("{time:?} after {:?}: times must ascend by a nanosecond at least", times[index - 1]);
            return Err(key.index(index).refuse(rule));
        }
    }
    Ok(Grid::List(times.to_vec()))
}
