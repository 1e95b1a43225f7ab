use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::rc::Rc;

use re_chunk::{Chunk, RowId, TimelineName};
use re_log_types::{LogMsg, StoreKind, StoreSource};

use super::super::messages::Messages;
use super::super::unpack;
use super::scalars;
use super::timeline::Timelines;
use super::transform::{Row, Transforms};
use crate::recording::RecordingError;
use crate::recording::foreign::gathering::{Gathering, Place, Statement};
use crate::recording::foreign::{Mapping, Observation};

/// Half a unit in the last place of an f32.
const SINGLE: f64 = 1.0 / 16_777_216.0;

/// Reads what an `.rrd` says of entities that turn; `None` if this crate wrote it and the mapping asks for no frame: its
/// plots say more than the pictures beside them.
///
/// # Errors
/// If it cannot be read, is damaged, or tells of no body that is asked for.
pub(in crate::recording) fn observe(path: &Path, mapping: &Mapping) -> Result<Option<Observation>, RecordingError> {
    if !mapping.body.is_empty() {
        return scalars::observe(path, mapping).map(Some);
    }
    // Which timeline is known only at the end: so it is read twice.
    let Some((timelines, parts)) = survey(path, mapping)? else { return Ok(None) };
    let refused = |reason| RecordingError::Decode { path: path.into(), reason };
    if !parts.contains(&Part::Moving) {
        let entities = if parts.is_empty() { "is empty" } else { "has others only, or what never changes" };
        return Err(refused(format!("no entity in it has transforms over time (Transform3D): it {entities}")));
    }
    let (timeline, remark) =
        timelines.choose(mapping).map_err(|reason| RecordingError::Mapping { path: path.into(), reason })?;
    let mut entities = BTreeMap::new();
    each_chunk(path, |chunk| {
        if Transforms::are_in(chunk) || has_relation(chunk) {
            entities.entry(chunk.entity_path().to_string()).or_insert_with(Entity::default).take(chunk, timeline)?;
        }
        Ok(())
    })?;
    let mut gathering = Gathering::new(mapping);
    if let Some(remark) = remark {
        gathering.remark(remark);
    }
    for (name, entity) in entities {
        entity.tell(&name, &mut gathering).map_err(|reason| refused(format!("{name}: {reason}")))?;
    }
    if gathering.is_empty() {
        return Err(refused(format!("no entity in it has transforms on the timeline {timeline}")));
    }
    gathering.observation().map(Some).map_err(refused)
}

/// What a file has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    Moving,
    Other,
}

/// Which timelines the transforms are on; `None` of a file of this crate, which is read otherwise.
fn survey(path: &Path, mapping: &Mapping) -> Result<Option<(Timelines, BTreeSet<Part>)>, RecordingError> {
    let (mut timelines, mut parts) = (Timelines::default(), BTreeSet::new());
    let mut messages = Messages::open(path)?;
    while let Some(message) = messages.next() {
        match message? {
            LogMsg::SetStoreInfo(store) if store.info.store_id.kind() == StoreKind::Recording => {
                let is_own =
                    matches!(&store.info.store_source, StoreSource::Other(name) if name.starts_with("polhode "));
                if is_own && mapping.frame.is_none() {
                    return Ok(None);
                }
            }
            LogMsg::ArrowMsg(store, batch) if store.kind() == StoreKind::Recording => {
                let chunk = unpack::chunk(&batch).map_err(|reason| messages.damaged(reason))?;
                let is_moving = !chunk.is_static() && Transforms::are_in(&chunk);
                parts.insert(if is_moving { Part::Moving } else { Part::Other });
                if is_moving {
                    timelines.see(&chunk);
                }
            }
            _ => {}
        }
    }
    Ok(Some((timelines, parts)))
}

pub(super) fn each_chunk(
    path: &Path,
    mut take: impl FnMut(&Chunk) -> Result<(), String>,
) -> Result<(), RecordingError> {
    let mut messages = Messages::open(path)?;
    while let Some(message) = messages.next() {
        if let LogMsg::ArrowMsg(store, batch) = message?
            && store.kind() == StoreKind::Recording
        {
            let taken = unpack::chunk(&batch).and_then(|chunk| take(&chunk));
            taken.map_err(|reason| messages.damaged(reason))?;
        }
    }
    Ok(())
}

fn has_relation(chunk: &Chunk) -> bool {
    let relation = re_sdk_types::archetypes::Transform3D::descriptor_relation().component;
    chunk.component_descriptors().any(|found| found.component == relation)
}

/// Attitude and position at one time.
type Pose = (Option<[f64; 4]>, Option<[f64; 3]>);

/// What the chunks say of one entity. Their order means nothing: times and numbers of rows do.
#[derive(Debug, Default)]
struct Entity {
    translations: BTreeMap<Row, [f64; 3]>,
    quaternions: BTreeMap<Row, [f64; 4]>,
    turns: BTreeMap<Row, [f64; 4]>,
    is_inverted: BTreeSet<bool>,
    children: BTreeMap<RowId, String>,
    parents: BTreeMap<RowId, String>,
}

impl Entity {
    fn take(&mut self, chunk: &Chunk, timeline: TimelineName) -> Result<(), String> {
        if !chunk.is_static() && !chunk.timelines().contains_key(&timeline) {
            return Ok(());
        }
        let said = Transforms::of(chunk, timeline)?;
        self.is_inverted.extend(said.inverted.into_iter().map(|(_, is_inverted)| is_inverted));
        if chunk.is_static() {
            return Ok(());
        }
        self.translations.extend(said.translations);
        self.quaternions.extend(said.quaternions);
        self.turns.extend(said.turns);
        self.children.extend(said.children.into_iter().map(|((_, row), frame)| (row, frame)));
        self.parents.extend(said.parents.into_iter().map(|((_, row), frame)| (row, frame)));
        Ok(())
    }

    /// Says it in the order of time. At equal times the later row counts, as in the viewer.
    fn tell(mut self, name: &str, gathering: &mut Gathering) -> Result<(), String> {
        if !self.quaternions.is_empty() && !self.turns.is_empty() {
            return Err("its attitude is told in two ways, which the viewer would multiply".into());
        }
        let is_inverted = self.is_inverted.contains(&true);
        if is_inverted && self.is_inverted.len() > 1 {
            return Err("some transforms are of the parent from the child, some the other way round".into());
        }
        if is_inverted {
            self.translations.clear();
            gathering
                .remark(format!("{name}: its transforms are of the child from the parent: positions are left out"));
        }
        let is_of_either_sign = !self.turns.is_empty();
        // A chunk of a few bytes unpacks to many rows: they share the names.
        let own = Rc::new(place(name, None, None));
        let place_of = |row: &RowId| match (self.children.get(row), self.parents.get(row)) {
            (None, None) => own.clone(),
            (child, parent) => Rc::new(place(name, child, parent)),
        };
        let mut latest: BTreeMap<(i64, Rc<Place>), Pose> = BTreeMap::new();
        for ((time, row), attitude) in self.quaternions.into_iter().chain(self.turns) {
            let [w, x, y, z] = attitude;
            let attitude = if is_inverted { [w, -x, -y, -z] } else { attitude };
            latest.entry((time, place_of(&row))).or_default().0 = Some(attitude);
        }
        for ((time, row), position) in self.translations {
            latest.entry((time, place_of(&row))).or_default().1 = Some(position);
        }
        for ((time, place), (attitude, position)) in latest {
            gathering.take(&Statement {
                place: Place::clone(&place),
                stamp_ns: Some(time),
                log_ns: time,
                attitude,
                position,
                resolution: SINGLE,
                is_of_either_sign,
                ..Statement::default()
            })?;
        }
        Ok(())
    }
}

/// An entity stands in its parent, unless its rows name frames.
fn place(entity: &str, child: Option<&String>, parent: Option<&String>) -> Place {
    let above = entity.rsplit_once('/').map_or("", |(above, _)| above);
    let fixed = parent.map_or_else(|| if above.is_empty() { "/".into() } else { above.into() }, String::clone);
    Place::transform(fixed, child.map_or_else(|| entity.into(), String::clone))
}
