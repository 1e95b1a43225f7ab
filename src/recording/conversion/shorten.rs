use crate::scenario::{Grid, Plan};

/// The same plan, ended after its first `kept` samples, as the recording of a run that was cut off holds them.
pub fn shortened(mut plan: Plan, kept: u64) -> Plan {
    let planned = plan.grid.len();
    match &mut plan.grid {
        Grid::Uniform { count, .. } => *count = kept,
        Grid::List(times) => times.truncate(usize::try_from(kept).unwrap_or(usize::MAX)),
    }
    let end = plan.grid.end();
    plan.events.retain(|event| event.time_s <= end);
    let what = what_was_kept(kept, Some(planned), end);
    plan.identity = format!("{}\n{what}", plan.identity);
    plan.summary = format!("{}\n\nRecovered from a run that was cut off: {what}.", plan.summary);
    plan
}

/// How much of a run there is, in words.
pub fn what_was_kept(kept: u64, planned: Option<u64>, end_s: f64) -> String {
    let planned = planned.map_or_else(|| "an unknown number of".to_owned(), |planned| planned.to_string());
    format!("the first {kept} of {planned} samples, to {end_s} s")
}
