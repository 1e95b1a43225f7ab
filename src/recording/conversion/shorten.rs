use crate::recording::Interruption;
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
    let what = Interruption { samples: kept, planned: Some(planned), to_s: end }.in_words();
    plan.identity = format!("{}\n{what}", plan.identity);
    plan.summary = format!("{}\n\nRecovered from a run that was cut off: {what}.", plan.summary);
    plan
}
