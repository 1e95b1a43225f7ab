use std::path::Path;
use std::sync::Arc;

use nalgebra::Vector3;

use super::table_file;
use crate::dynamics::{Interpolation, Profile};
use crate::scenario::plan::rules::{finite, not_negative, positive, unit_vector, vector};
use crate::scenario::{AfterTable, Key, Refusal, RotorSpec, TableSpec, ThrusterSpec};

/// Times beyond it are of no run, s.
const LATEST: f64 = 9e9;
/// Pulses of one thruster at most.
const MOST_PULSES: f64 = 1e6;

type Points = Vec<(f64, Vector3<f64>)>;

/// What a table says, its vectors turned by `turn`.
pub fn table(
    key: &Key,
    spec: &TableSpec,
    folder: &Path,
    turn: impl Fn(Vector3<f64>) -> Vector3<f64>,
) -> Result<Arc<Profile>, Refusal> {
    let (source, rows) = match (&spec.file, &spec.rows) {
        (Some(file), None) => {
            let key = key.field("file");
            let rows = table_file::read(&folder.join(file)).map_err(|error| key.refuse(error))?;
            (key, rows)
        }
        (None, Some(rows)) => (key.field("rows"), rows.clone()),
        (Some(_), Some(_)) => return Err(key.field("rows").refuse("given beside file: one of the two")),
        (None, None) => return Err(key.refuse("needs a file, or rows")),
    };
    let mut points = Points::new();
    for (index, [time, x, y, z]) in rows.into_iter().enumerate() {
        let key = if spec.rows.is_some() { source.index(index) } else { source.clone() };
        ascending(&key, time, points.last().map(|point| point.0))?;
        points.push((time, turn(vector(&key, [x, y, z])?)));
    }
    let [_, .., (_, last)] = points.as_slice() else {
        return Err(source.refuse(format_args!("{} rows: a table has two at least", points.len())));
    };
    let after = if spec.after == AfterTable::Hold { *last } else { Vector3::zeros() };
    made(&source, &points, spec.interpolation, [Vector3::zeros(), after])
}

/// The pulses of a thruster until `end`, s, of the force that its direction and level make.
pub fn thruster(
    key: &Key,
    spec: &ThrusterSpec,
    end: f64,
    turn: impl Fn(Vector3<f64>) -> Vector3<f64>,
) -> Result<Arc<Profile>, Refusal> {
    let direction = unit_vector(&key.field("direction"), spec.direction)?;
    let force = turn(direction * not_negative(&key.field("thrust_n"), spec.thrust_n)?);
    let pulses = match (&spec.pulses_s, spec.period_s, spec.duty) {
        (Some(pulses), None, None) => listed(&key.field("pulses_s"), pulses)?,
        (None, Some(period), Some(duty)) => {
            let start = spec.start_s.unwrap_or(0.0);
            periodic(key, start, spec.end_s.unwrap_or(end).min(end), period, duty)?
        }
        (Some(_), ..) => return Err(key.field("pulses_s").refuse("given beside period_s or duty: one of the two")),
        (None, ..) => return Err(key.refuse("needs pulses_s, or period_s and duty")),
    };
    let mut points = Points::new();
    for [on, off, amplitude] in pulses {
        // One pulse may follow the other without a pause.
        if points.last().is_some_and(|point| point.0 == on) {
            points.pop();
        }
        points.extend([(on, amplitude * force), (off, Vector3::zeros())]);
    }
    let nothing = Vector3::zeros();
    if points.is_empty() {
        return Ok(Arc::new(Profile::constant(nothing)));
    }
    made(key, &points, Interpolation::Hold, [nothing; 2])
}

/// [on, off] or [on, off, amplitude], one after the other.
fn listed(key: &Key, pulses: &[Vec<f64>]) -> Result<Vec<[f64; 3]>, Refusal> {
    let mut all: Vec<[f64; 3]> = Vec::new();
    for (index, pulse) in pulses.iter().enumerate() {
        let key = key.index(index);
        let (on, off, amplitude) = match *pulse.as_slice() {
            [on, off] => (on, off, 1.0),
            [on, off, amplitude] => (on, off, not_negative(&key, amplitude)?),
            _ => return Err(key.refuse(format_args!("{pulse:?} is no pulse: [on, off] or [on, off, amplitude]"))),
        };
        let before = all.last().map_or(0.0, |last| last[1]);
        if !(before <= on && on < off && off <= LATEST) {
            let rule = format!("{pulse:?}: on ≥ {before:?}, off after it, at most {LATEST:e} s");
            return Err(key.refuse(rule));
        }
        all.push([on, off, amplitude]);
    }
    Ok(all)
}

/// On for a share of each period.
fn periodic(key: &Key, start: f64, end: f64, period: f64, duty: f64) -> Result<Vec<[f64; 3]>, Refusal> {
    let period = positive(&key.field("period_s"), period)?;
    let duty_key = key.field("duty");
    if positive(&duty_key, duty)? > 1.0 {
        return Err(duty_key.refuse(format_args!("{duty:?} is more than the whole period: at most 1")));
    }
    let count = ((end - start) / period).ceil();
    if count > MOST_PULSES {
        let rule = format!("{period:?} s makes {count:e} pulses: at most {MOST_PULSES:e}");
        return Err(key.field("period_s").refuse(rule));
    }
    let on = |number: f64| start + number * period;
    let numbers =
        std::iter::successors(Some(0.0), |number: &f64| Some(number + 1.0)).take_while(|number| *number < count);
    let pulses: Vec<[f64; 3]> =
        numbers.map(|number| [on(number), (on(number) + duty * period).min(on(number + 1.0)), 1.0]).collect();
    if pulses.iter().any(|[on, off, _]| off <= on) {
        return Err(duty_key.refuse(format_args!("{duty:?} of {period:?} s is no time at all")));
    }
    Ok(pulses)
}

/// A rotor's momentum along its axis, constant or by straight lines.
pub fn rotor(
    key: &Key,
    spec: &RotorSpec,
    turn: impl Fn(Vector3<f64>) -> Vector3<f64>,
) -> Result<Arc<Profile>, Refusal> {
    let axis = turn(unit_vector(&key.field("axis"), spec.axis)?);
    let momenta_key = key.field("momenta_n_m_s");
    let (times, momenta) = match (spec.momentum_n_m_s, &spec.times_s, &spec.momenta_n_m_s) {
        (Some(momentum), None, None) => {
            let momentum = finite(&key.field("momentum_n_m_s"), momentum)?;
            return Ok(Arc::new(Profile::constant(momentum * axis)));
        }
        (None, Some(times), Some(momenta)) => (times, momenta),
        (Some(_), ..) => {
            return Err(key.field("momentum_n_m_s").refuse("given beside times_s or momenta_n_m_s: one of the two"));
        }
        (None, ..) => return Err(key.refuse("needs momentum_n_m_s, or times_s and momenta_n_m_s")),
    };
    if times.len() != momenta.len() || times.is_empty() {
        let rule = format!("{} momenta at {} times: as many of both, one at least", momenta.len(), times.len());
        return Err(momenta_key.refuse(rule));
    }
    let mut points = Points::new();
    for (index, (time, momentum)) in times.iter().zip(momenta).enumerate() {
        let times_key = key.field("times_s").index(index);
        ascending(&times_key, *time, points.last().map(|point| point.0))?;
        points.push((*time, finite(&momenta_key.index(index), *momentum)? * axis));
    }
    let outside = [points[0].1, points[points.len() - 1].1];
    made(key, &points, Interpolation::Linear, outside)
}

fn ascending(key: &Key, time: f64, before: Option<f64>) -> Result<(), Refusal> {
    if !time.is_finite() || time.abs() > LATEST {
        return Err(key.refuse(format_args!("{time:?} s is no time of a run: at most {LATEST:e}")));
    }
    if before.is_some_and(|before| time <= before) {
        return Err(key.refuse(format_args!("{time:?} s does not come after the time before it")));
    }
    Ok(())
}

fn made(
    key: &Key,
    points: &[(f64, Vector3<f64>)],
    interpolation: Interpolation,
    outside: [Vector3<f64>; 2],
) -> Result<Arc<Profile>, Refusal> {
    let profile = Profile::through(points, interpolation, outside).filter(Profile::is_finite);
    profile.map(Arc::new).ok_or_else(|| key.refuse("its points lie so close that f64 cannot hold the slopes"))
}
