use std::collections::BTreeMap;
use std::path::Path;

use re_chunk::{Chunk, RowId, TimelineName};
use re_sdk_types::archetypes::Scalars;

use super::super::unpack;
use super::read::each_chunk;
use super::timeline::Timelines;
use crate::recording::RecordingError;
use crate::recording::foreign::gathering::{seconds, start_of};
use crate::recording::foreign::table::{Columns, Numbers, Parts};
use crate::recording::foreign::{Mapping, Observation};

/// Most numbers of all entities at one time.
const WIDEST: usize = 1 << 16;

/// Reads bodies from `Scalars`, by a mapping: a column is an entity, or one of its numbers, `/entity:1` the first.
///
/// # Errors
/// If it cannot be read, is damaged, does not fit the mapping, or columns of one file are told at different times.
pub(super) fn observe(path: &Path, mapping: &Mapping) -> Result<Observation, RecordingError> {
    let refused = |reason| RecordingError::Mapping { path: path.into(), reason };
    let (mut timelines, mut widths) = (Timelines::default(), BTreeMap::new());
    each_chunk(path, |chunk| {
        if let Some(width) = width(chunk)? {
            timelines.see(chunk);
            widths.insert(chunk.entity_path().to_string(), width);
        }
        Ok(())
    })?;
    let width: usize = widths.values().sum();
    if width > WIDEST {
        return Err(refused(format!("it has {width} columns of scalars, more than {WIDEST}")));
    }
    let (timeline, remark) = timelines.choose(mapping).map_err(refused)?;
    let (names, sources): (Vec<_>, Vec<_>) =
        widths.iter().flat_map(|(entity, width)| columns_of(entity, *width)).unzip();
    let mut columns = Columns::new(&names, names.len());
    let parts: Result<Vec<_>, _> = mapping.body.iter().map(|body| Parts::find(body, &mut columns)).collect();
    let parts = parts.map_err(refused)?;
    let wanted: Vec<_> = columns.places().iter().filter_map(|place| sources.get(*place)).collect();
    let mut rows: Vec<BTreeMap<(i64, RowId), f64>> = vec![BTreeMap::new(); wanted.len()];
    each_chunk(path, |chunk| {
        let entity = chunk.entity_path().to_string();
        for ((source, index), rows) in wanted.iter().zip(&mut rows).filter(|((source, _), _)| *source == entity) {
            take(chunk, timeline, *index, rows).map_err(|reason| format!("{source}: {reason}"))?;
        }
        Ok(())
    })?;
    let (numbers, start_ns) = numbers(&wanted, rows).map_err(refused)?;
    let bodies = parts.iter().zip(&mapping.body).map(|(parts, body)| parts.observed(body, &numbers));
    let bodies = bodies.collect::<Result<_, _>>().map_err(refused)?;
    let remarks = remark.into_iter().collect();
    let observation = Observation { bodies, start_ns, time_resolution_s: 5e-10, remarks };
    observation.claim_names().map_err(refused)?;
    Ok(observation)
}

/// How many numbers the first row of a chunk has; `None` if it has no scalars over time.
fn width(chunk: &Chunk) -> Result<Option<usize>, String> {
    let component = Scalars::descriptor_scalars().component;
    if chunk.is_static() {
        return Ok(None);
    }
    let first = unpack::guarded(|| Ok(chunk.iter_slices::<f64>(component).next().map(<[f64]>::len)))?;
    match first {
        Some(width) if width > WIDEST => Err(format!("{width} scalars in a row")),
        other => Ok(other),
    }
}

/// The names of an entity's columns, and where each is.
fn columns_of(entity: &str, width: usize) -> Vec<(String, (String, usize))> {
    let column = |index| {
        let name = if width == 1 { entity.to_owned() } else { format!("{entity}:{}", index + 1) };
        (name, (entity.to_owned(), index))
    };
    (0..width).map(column).collect()
}

/// The numbers at one place of the rows of a chunk.
fn take(
    chunk: &Chunk,
    timeline: TimelineName,
    index: usize,
    taken: &mut BTreeMap<(i64, RowId), f64>,
) -> Result<(), String> {
    let component = Scalars::descriptor_scalars().component;
    if chunk.is_static() || !chunk.timelines().contains_key(&timeline) {
        return Ok(());
    }
    unpack::guarded(|| {
        let indices = chunk.iter_component_indices(timeline, component);
        for ((time, row), values) in indices.zip(chunk.iter_slices::<f64>(component)) {
            let value = values.get(index).filter(|value| value.is_finite());
            let value = value
                .ok_or_else(|| format!("number {} at {} ns is not there or not finite", index + 1, time.as_i64()))?;
            taken.insert((time.as_i64(), row), *value);
        }
        Ok(())
    })
}

/// The columns, if they are told at the same times, and what the timeline shows at 0 s. Of several rows at one time the
/// latest counts, as in the viewer.
fn numbers(wanted: &[&(String, usize)], rows: Vec<BTreeMap<(i64, RowId), f64>>) -> Result<(Numbers, i64), String> {
    let rows: Vec<BTreeMap<i64, f64>> =
        rows.into_iter().map(|rows| rows.into_iter().map(|((time, _), value)| (time, value)).collect()).collect();
    let first = rows.first().ok_or("the mapping names no column")?;
    if let Some(other) = rows.iter().position(|other| !other.keys().eq(first.keys())) {
        return Err(format!("{} is told at other times than {}", wanted[other].0, wanted[0].0));
    }
    let start_ns = start_of(*first.keys().next().ok_or("no row is on the timeline")?);
    let times_s: Vec<f64> = first.keys().map(|time| seconds(*time, start_ns)).collect();
    if let Some([last, next]) = times_s.array_windows().find(|[last, next]| next <= last) {
        return Err(format!("a row is at {next} s, after one at {last} s: seconds do not tell their ns apart"));
    }
    let columns = rows.iter().map(|column| column.values().copied().collect()).collect();
    Ok((Numbers { times_s, columns, ..Numbers::default() }, start_ns))
}
