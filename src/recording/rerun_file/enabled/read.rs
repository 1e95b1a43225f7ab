use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use re_chunk::{Chunk, TimelineName};
use re_log_types::{LogMsg, StoreId, StoreKind, StoreSource};

use super::columns::SIM_TIME;
use super::messages::{End, Messages};
use super::unpack;
use crate::recording::{Contents, Entry, RecordingError};

/// Looks into an `.rrd`, whoever wrote it, from end to end: its entities with their rows and times on `sim_time`. Of a
/// `.part` that is cut off, as far as it goes.
///
/// # Errors
/// If it cannot be read, is damaged, or cut off and no `.part`.
pub fn contents(path: &Path) -> Result<Contents, RecordingError> {
    let mut messages = Messages::open(path)?;
    let mut survey = Survey::default();
    while let Some(message) = messages.next() {
        match message? {
            LogMsg::SetStoreInfo(store) => survey.see_store(&store.info.store_id, &store.info.store_source),
            LogMsg::ArrowMsg(store, batch) if store.kind() == StoreKind::Recording => {
                let chunk = unpack::chunk(&batch).map_err(|reason| messages.damaged(reason))?;
                survey.see_chunk(&chunk);
            }
            LogMsg::ArrowMsg(..) => survey.layout_chunks += 1,
            LogMsg::BlueprintActivationCommand(_) => {}
        }
    }
    let is_complete = messages.end() == End::Whole;
    let state = if is_complete { "complete" } else { "unfinished: the end is missing" };
    let mut details = vec![("state".into(), state.into())];
    details.extend(survey.details);
    details.push(("rerun version".into(), messages.version().to_string()));
    details.push(("layout".into(), format!("{} parts", survey.layout_chunks)));
    Ok(Contents {
        format: "rrd",
        is_whole: messages.end() == End::Whole,
        details,
        entries: survey.entities.into_iter().map(Entity::entry).collect(),
        survey: None,
    })
}

/// What was met so far.
#[derive(Default)]
struct Survey {
    details: Vec<(String, String)>,
    entities: BTreeMap<String, Entity>,
    layout_chunks: u64,
}

/// What was met of one entity.
#[derive(Default)]
struct Entity {
    archetypes: BTreeSet<String>,
    rows: u64,
    static_rows: u64,
    span_ns: Option<(i64, i64)>,
}

impl Survey {
    fn see_store(&mut self, store: &StoreId, source: &StoreSource) {
        if store.kind() == StoreKind::Recording {
            self.details.push(("application".into(), store.application_id().to_string()));
            self.details.push(("recording".into(), store.recording_id().to_string()));
            let writer = match source {
                StoreSource::Other(name) => name.clone(),
                other => other.to_string(),
            };
            self.details.push(("written by".into(), writer));
        }
    }

    fn see_chunk(&mut self, chunk: &Chunk) {
        let entity = self.entities.entry(chunk.entity_path().to_string()).or_default();
        for component in chunk.component_descriptors() {
            let name = component.archetype.map_or(component.component.as_str(), |archetype| archetype.short_name());
            if !entity.archetypes.contains(name) {
                entity.archetypes.insert(name.to_owned());
            }
        }
        let rows = chunk.num_rows() as u64;
        if chunk.is_static() {
            entity.static_rows += rows;
            return;
        }
        entity.rows += rows;
        let timeline = chunk.timelines().iter().find(|(name, _)| TimelineName::as_str(name) == SIM_TIME);
        if let Some((_, column)) = timeline
            && rows > 0
        {
            let (first, last) = (column.time_range().min().as_i64(), column.time_range().max().as_i64());
            let (from, to) = entity.span_ns.unwrap_or((first, last));
            entity.span_ns = Some((from.min(first), to.max(last)));
        }
    }
}

impl Entity {
    fn entry((name, entity): (String, Self)) -> Entry {
        Entry {
            name,
            kind: Vec::from_iter(entity.archetypes).join(", "),
            count: if entity.rows > 0 { entity.rows } else { entity.static_rows },
            from_s: entity.span_ns.map(|(from, _)| seconds(from)),
            to_s: entity.span_ns.map(|(_, to)| seconds(to)),
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "a time for people")]
fn seconds(nanoseconds: i64) -> f64 {
    nanoseconds as f64 / 1e9
}
