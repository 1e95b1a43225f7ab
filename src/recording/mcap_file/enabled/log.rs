use std::collections::BTreeMap;
use std::vec::IntoIter;

use prost::Message;

use super::container::{Output, Topic};
use super::foxglove::{LOG, Log, Timestamp};
use crate::recording::{Interruption, RecordingError, Subject};
use crate::scenario::{Event, EventKind, Plan, nanoseconds};

/// What happens in the run, in words, on `/log`.
#[derive(Debug)]
pub(super) struct EventLog {
    topic: Topic,
    next: Option<(i64, Log)>,
    later: IntoIter<(i64, Log)>,
}

impl EventLog {
    /// The start, at the time of the first sample or event, and the events of a plan.
    pub fn new(subject: &Subject, output: &mut Output) -> Result<Self, RecordingError> {
        let mut entries = subject.drawing.map(|(plan, _)| events(plan)).unwrap_or_default();
        let first_sample = nanoseconds(subject.sampling.from_s);
        let start = entries.first().map_or(first_sample, |(stamp, _)| first_sample.min(*stamp));
        entries.insert(0, entry(start, &subject.name, &subject.title));
        let mut later = entries.into_iter();
        let topic = output.topic("/log", LOG, &BTreeMap::new())?;
        Ok(Self { topic, next: later.next(), later })
    }

    /// Tells what has happened until `stamp_ns`, that instant included.
    pub fn tell_until(&mut self, stamp_ns: i64, output: &mut Output) -> Result<(), RecordingError> {
        while let Some((stamp, log)) = self.next.take_if(|(stamp, _)| *stamp <= stamp_ns) {
            output.send(&mut self.topic, stamp, |bytes| log.encode_raw(bytes))?;
            self.next = self.later.next();
        }
        Ok(())
    }

    /// Tells that the run was stopped, at the time of its last sample.
    pub fn tell_interruption(&mut self, end: &Interruption, output: &mut Output) -> Result<(), RecordingError> {
        let (stamp, mut log) = entry(nanoseconds(end.to_s), "run", &format!("interrupted: {}", end.in_words()));
        log.level = Log::WARNING;
        output.send(&mut self.topic, stamp, |bytes| log.encode_raw(bytes))
    }
}

/// What happens to the bodies, in order of time.
fn events(plan: &Plan) -> Vec<(i64, Log)> {
    let event = |event: &Event| {
        let body = plan.bodies.get(event.body).map_or("", |body| &body.name);
        let (stamp, mut log) = entry(nanoseconds(event.time_s), body, &event.text);
        if event.kind == EventKind::Failed {
            log.level = Log::WARNING;
        }
        (stamp, log)
    };
    let mut entries: Vec<_> = plan.events.iter().map(event).collect();
    entries.sort_by_key(|(stamp, _)| *stamp);
    entries
}

fn entry(stamp_ns: i64, name: &str, message: &str) -> (i64, Log) {
    let timestamp = Some(Timestamp::of(stamp_ns));
    (stamp_ns, Log { timestamp, level: Log::INFO, message: message.into(), name: name.into() })
}
