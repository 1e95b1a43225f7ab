use std::collections::BTreeMap;

use mcap::records::Metadata;
use mcap::{McapError, McapResult};

use crate::recording::{Contents, Entry};

/// What was met in a file.
#[derive(Debug, Default)]
pub(super) struct Tally {
    pub library: String,
    pub is_complete: bool,
    pub metadata: Vec<Metadata>,
    pub schemas: BTreeMap<u16, String>,
    pub topics: BTreeMap<u16, Topic>,
    pub attachments: Vec<(String, String)>,
}

#[derive(Debug)]
pub(super) struct Topic {
    pub name: String,
    pub schema: String,
    pub count: u64,
    /// First and last log time, ns.
    pub times: Option<(u64, u64)>,
}

impl Tally {
    pub fn add_attachment(&mut self, name: &str, media_type: &str, bytes: u64) {
        self.attachments.push((format!("attachment {name}"), format!("{media_type}, {bytes} bytes")));
    }

    pub fn add_channel(&mut self, id: u16, schema: u16, name: String) {
        let schema = self.schemas.get(&schema).cloned().unwrap_or_default();
        // A file repeats its channels in the summary.
        self.topics.entry(id).or_insert(Topic { name, schema, count: 0, times: None });
    }

    pub fn add_message(&mut self, channel: u16, time: u64) -> McapResult<()> {
        let topic = self.topics.get_mut(&channel).ok_or(McapError::UnknownChannel(0, channel))?;
        topic.count += 1;
        topic.times = Some(topic.times.map_or((time, time), |(first, last)| (first.min(time), last.max(time))));
        Ok(())
    }

    pub fn into_contents(self) -> Contents {
        let state = if self.is_complete { "complete" } else { "unfinished: the end is missing" };
        let mut details = vec![("state".into(), state.into()), ("library".into(), self.library)];
        details.extend(self.metadata.into_iter().flat_map(|metadata| metadata.metadata));
        details.extend(self.attachments);
        let mut entries: Vec<Entry> = self.topics.into_values().map(Topic::into_entry).collect();
        entries.sort_by(|a, b| a.name.cmp(&b.name));
        Contents { format: "mcap", is_whole: self.is_complete, details, entries, survey: None }
    }
}

impl Topic {
    fn into_entry(self) -> Entry {
        let (from_s, to_s) = self.times.map(|(first, last)| (seconds(first), seconds(last))).unzip();
        Entry { name: self.name, kind: self.schema, count: self.count, from_s, to_s }
    }
}

#[expect(clippy::cast_precision_loss, reason = "a time for people")]
fn seconds(ns: u64) -> f64 {
    ns as f64 / 1e9
}
