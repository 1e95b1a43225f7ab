use std::path::Path;

use super::shorten::shortened;
use crate::recording::subject::CHECK;
use crate::recording::{Heading, Range, Recording, Sampling, Survey, subject};
use crate::scenario::{Certificate, Plan, Watched};
use crate::telemetry::{BodySamples, Channel};

/// The fact that a recording was recovered; its value says how much of it.
pub const RECOVERED: &str = "recovered";
/// The fact which version computed the samples: another one is no other scene.
const VERSION: &str = "polhode_version";
/// How far a value may be from the plan's, in units of the largest of its column.
const FIT: f64 = 1e-6;

/// `plan` as the plan of the run that the recording is of, with the certificates that it carries; else why it is not.
/// With `is_cut_off` the recording may hold fewer samples than planned.
pub fn fitted(mut plan: Plan, survey: &Survey, is_cut_off: bool) -> Result<Plan, String> {
    check_bodies(&plan, &survey.heading)?;
    for (body, recorded) in plan.bodies.iter_mut().zip(&survey.heading.bodies) {
        body.certificate = Certificate::from_facts(&recorded.certificate);
    }
    if survey.heading.provenance.iter().any(|(name, _)| name.starts_with(CHECK)) {
        plan = plan.checked().map_err(|error| format!("its checks cannot be measured: {error}"))?;
    }
    let was_cut_off = survey.heading.fact(RECOVERED).is_some();
    let is_shorter = survey.sampling().samples < plan.grid.len();
    if was_cut_off && is_shorter {
        plan = shortened(plan, survey.sampling().samples);
    }
    check_facts(&plan, &survey.heading)?;
    if is_cut_off && !was_cut_off && is_shorter {
        plan = shortened(plan, survey.sampling().samples);
    }
    check_times(Sampling::of(&plan.grid), survey.sampling())?;
    if let Some(version) = survey.heading.fact(VERSION).filter(|version| *version != env!("CARGO_PKG_VERSION")) {
        plan.summary = format!("{}\n\nComputed by polhode {version}.", plan.summary);
    }
    Ok(plan)
}

/// Whether a recording tells of which scene it is: a table does not, nor does what was made of one.
pub fn tells_scene(heading: &Heading) -> bool {
    heading.fact("scene").is_some()
}

/// Holds values of the recording at `path`, about one a batch, against those of the plan: columns without words could be
/// of another scene.
pub fn check_values(plan: &Plan, survey: &Survey, path: &Path) -> Result<(), String> {
    let mut looks = Looks::new(plan);
    let mut recording = Recording::open(path).map_err(|error| error.to_string())?;
    while let Some(samples) = recording.next_batch().map_err(|error| error.to_string())? {
        for index in [0, samples.len() - 1] {
            looks.add(samples.times_s[index], &samples.bodies, index);
        }
    }
    let mut ranges = survey.ranges.iter();
    for (watched, recorded) in plan.watched().zip(&looks.bodies) {
        let expected = watched.sample(watched.channels(), &looks.times_s).map_err(|error| error.to_string())?;
        for channel in watched.channels() {
            let columns = |samples: &BodySamples| samples.channel(*channel).unwrap_or_default().to_vec();
            for (expected, recorded) in columns(&expected).iter().zip(&columns(recorded)) {
                let largest = ranges.next().map_or(0.0, Range::largest);
                check_column(watched, *channel, largest, &looks.times_s, (expected, recorded))?;
            }
        }
    }
    Ok(())
}

/// Samples picked out of a recording.
struct Looks {
    times_s: Vec<f64>,
    bodies: Vec<BodySamples>,
}

impl Looks {
    fn new(plan: &Plan) -> Self {
        let bodies = plan.watched().map(|watched| BodySamples::new(watched.channels())).collect();
        Self { times_s: Vec::new(), bodies }
    }

    fn add(&mut self, time_s: f64, bodies: &[BodySamples], index: usize) {
        if self.times_s.last() == Some(&time_s) {
            return;
        }
        self.times_s.push(time_s);
        for (kept, samples) in self.bodies.iter_mut().zip(bodies) {
            for (kept, column) in kept.columns_mut().iter_mut().zip(samples.columns()) {
                kept.push(column[index]);
            }
        }
    }
}

fn check_column(
    watched: Watched,
    channel: Channel,
    largest: f64,
    times_s: &[f64],
    (expected, recorded): (&[f64], &[f64]),
) -> Result<(), String> {
    if matches!(channel, Channel::EnergyDrift | Channel::MomentumDrift | Channel::Slip) {
        // Roundings of the version that computed them.
        return Ok(());
    }
    for ((time_s, expected), recorded) in times_s.iter().zip(expected).zip(recorded) {
        let is_near = (expected - recorded).abs() <= FIT * largest || expected.to_bits() == recorded.to_bits();
        if !is_near {
            let name = channel.row().name;
            return Err(format!("{name} of {} at {time_s} s is {recorded}, not {expected}", watched.name()));
        }
    }
    Ok(())
}

fn check_bodies(plan: &Plan, heading: &Heading) -> Result<(), String> {
    let (planned, recorded) = (plan.watched().count(), heading.bodies.len());
    if planned != recorded {
        return Err(format!("the scene has {planned} bodies, probes and IMUs, the recording {recorded}"));
    }
    let tells_names = tells_scene(heading) || recorded > 1;
    for (watched, recorded) in plan.watched().zip(&heading.bodies) {
        let name = watched.name();
        if tells_names && name != recorded.name {
            return Err(format!("the scene has a body {name}, the recording {}", recorded.name));
        }
        if watched.channels() != recorded.channels {
            return Err(format!("the scene has other channels of {name} than the recording"));
        }
    }
    Ok(())
}

/// What the plan says of itself, the recording says too.
fn check_facts(plan: &Plan, heading: &Heading) -> Result<(), String> {
    if !tells_scene(heading) {
        return Ok(());
    }
    // Of what differs, words say more than hashes.
    let (hashes, words): (Vec<_>, _) =
        subject::of_plan(plan).into_iter().partition(|(name, _)| name.ends_with("_sha256"));
    for (name, value) in std::iter::chain(words, hashes) {
        let recorded = heading.fact(&name);
        // Another version may measure another last digit.
        let is_free = name == VERSION || name.starts_with(CHECK);
        if !is_free && recorded != Some(value.as_str()) {
            let recorded = recorded.unwrap_or("nothing");
            return Err(format!("{name} is {recorded:?} in the recording, {value:?} in the scene"));
        }
    }
    Ok(())
}

fn check_times(planned: Sampling, recorded: Sampling) -> Result<(), String> {
    let has_interval =
        planned.interval_s.is_none() || recorded.samples < 2 || planned.interval_s == recorded.interval_s;
    if planned.samples == recorded.samples
        && planned.from_s == recorded.from_s
        && planned.to_s == recorded.to_s
        && has_interval
    {
        return Ok(());
    }
    let words =
        |sampling: Sampling| format!("{} samples from {} to {} s", sampling.samples, sampling.from_s, sampling.to_s);
    Err(format!("the scene has {}, the recording {}", words(planned), words(recorded)))
}
