use std::collections::BTreeSet;

use crate::recording::{Heading, RecordedBody};
use crate::telemetry::Channel;

/// What comes first.
pub(super) const TIME: &str = "time_s";
/// What stands for the name of a single body, which is not written.
const SINGLE: &str = "body";

/// The line that names the columns.
pub(super) fn header(bodies: &[RecordedBody]) -> String {
    let one_body = bodies.len() == 1;
    let columns = bodies.iter().flat_map(|body| {
        let prefix = if one_body { String::new() } else { format!("{}.", body.name) };
        columns(&body.channels).map(move |column| format!("{prefix}{column}"))
    });
    let names: Vec<String> = std::iter::once(TIME.into()).chain(columns).collect();
    names.join(",")
}

fn columns(channels: &[Channel]) -> impl Iterator<Item = String> {
    let rows = channels.iter().map(|channel| channel.row());
    rows.flat_map(|row| (0..row.components.len()).map(move |index| row.column_name(index)))
}

/// What that line says.
///
/// # Errors
/// Which column breaks which rule.
pub(super) fn heading(line: &str) -> Result<Heading, String> {
    let mut names = line.split(',').enumerate().map(|(index, name)| (index + 1, name));
    if let Some((_, first)) = names.next().filter(|(_, first)| *first != TIME) {
        return Err(format!("the first column is {first:?}, not {TIME:?}"));
    }
    let (mut bodies, mut known): (Vec<RecordedBody>, BTreeSet<&str>) = Default::default();
    while let Some((number, name)) = names.next() {
        let (body, column) = name.split_once('.').unwrap_or((SINGLE, name));
        let channel = first_column_of(column).ok_or_else(|| format!("column {number}, {name:?}, begins no channel"))?;
        for expected in columns(&[channel]).skip(1) {
            let found = names.next().map(|(_, name)| name.split_once('.').unwrap_or((SINGLE, name)));
            if found != Some((body, expected.as_str())) {
                return Err(format!("after column {number}, {name:?}, {expected:?} of the same body is missing"));
            }
        }
        let is_next = bodies.last().is_some_and(|last| last.name == body);
        if !is_next {
            if bodies.len() == Heading::MOST_BODIES {
                return Err(format!("column {number}, {name:?}: more than {} bodies", Heading::MOST_BODIES));
            }
            if !known.insert(body) {
                return Err(format!("column {number}, {name:?}: the columns of a body stand side by side"));
            }
            bodies.push(RecordedBody { name: body.into(), ..RecordedBody::default() });
        }
        if let Some(body) = bodies.last_mut() {
            if body.channels.contains(&channel) {
                return Err(format!("column {number}, {name:?}, is there twice"));
            }
            body.channels.push(channel);
        }
    }
    Ok(Heading { bodies, ..Heading::default() })
}

/// Whether a line names columns as [`header`] does.
pub(in crate::recording) fn names_own_columns(line: &str) -> bool {
    heading(line).is_ok_and(|heading| !heading.bodies.is_empty())
}

fn first_column_of(column: &str) -> Option<Channel> {
    Channel::ALL.into_iter().find(|channel| channel.row().column_name(0) == column)
}
