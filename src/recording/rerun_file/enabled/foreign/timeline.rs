use std::collections::BTreeMap;

use re_chunk::{Chunk, TimelineName};
use re_log_types::TimeType;

use crate::recording::foreign::Mapping;

/// When rows were logged, as the SDK notes by itself.
const LOG_TIME: &str = "log_time";
/// How many were logged before, likewise.
const LOG_TICK: &str = "log_tick";

/// The timelines of the rows that matter.
#[derive(Debug, Default)]
pub(super) struct Timelines {
    found: BTreeMap<String, (TimelineName, TimeType)>,
}

impl Timelines {
    pub fn see(&mut self, chunk: &Chunk) {
        for (name, column) in chunk.timelines() {
            self.found.insert(name.as_str().to_owned(), (*name, column.timeline().typ()));
        }
    }

    /// The one that holds the times of the motion, and a remark where it is taken for granted.
    ///
    /// # Errors
    /// If there is none, or several, or the one asked for holds numbers and no times.
    pub fn choose(&self, mapping: &Mapping) -> Result<(TimelineName, Option<String>), String> {
        if let Some(name) = &mapping.timeline {
            return match self.found.get(name) {
                None => Err(format!("it has no timeline {name:?}: they are {}", self.names(|_, _| true))),
                Some((_, TimeType::Sequence)) => Err(format!("the timeline {name:?} counts: it tells no times")),
                Some((timeline, _)) => Ok((*timeline, None)),
            };
        }
        let is_of_times = |name: &str, kind: TimeType| kind != TimeType::Sequence && name != LOG_TIME;
        let mut candidates = self.found.iter().filter(|(name, (_, kind))| is_of_times(name, *kind));
        match (candidates.next(), candidates.next()) {
            (Some((_, (timeline, _))), None) => Ok((*timeline, None)),
            (Some(_), Some(_)) => Err(format!("it has several timelines, {}: which of them?", self.names(is_of_times))),
            (None, _) => {
                let counting = self.names(|name, kind| kind == TimeType::Sequence && name != LOG_TICK);
                if !counting.is_empty() {
                    return Err(format!("its timeline {counting} counts: no timeline tells the times of the motion"));
                }
                let (timeline, _) = self.found.get(LOG_TIME).ok_or("it has no timeline of times")?;
                let remark = "no timeline but log_time: times are those at which rows were logged".into();
                Ok((*timeline, Some(remark)))
            }
        }
    }

    fn names(&self, is_wanted: impl Fn(&str, TimeType) -> bool) -> String {
        let names = self.found.iter().filter(|(name, (_, kind))| is_wanted(name, *kind)).map(|(name, _)| name.as_str());
        names.collect::<Vec<_>>().join(", ")
    }
}
