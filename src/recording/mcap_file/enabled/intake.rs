use std::collections::BTreeMap;
use std::io::Error;

use mcap::records::{Channel as Topic, MessageHeader, Metadata, Record, op};
use mcap::{McapError, McapResult};

use super::parse::parse;
use super::scan::attachment;
use super::state::{self, StateLayout};
use crate::recording::subject::certificate;
use crate::recording::{Heading, RecordedBody};
use crate::scenario::nanoseconds;
use crate::telemetry::{BodySamples, Channel, Samples};

/// What the records of a file bring: the heading, then sample after sample, one message for each body in turn.
#[derive(Default)]
pub(super) struct Intake {
    heading: Heading,
    /// By number: the name, and which channels it describes if it is a description of [`state::NAME`] that this crate
    /// embeds.
    schemas: BTreeMap<u16, (String, Option<Vec<Channel>>)>,
    /// By number of the topic: number of the body.
    topics: BTreeMap<u16, usize>,
    layouts: Vec<StateLayout>,
    samples: Samples,
    /// Whose message comes next.
    next: usize,
    has_begun: bool,
}

impl Intake {
    pub fn heading(&self) -> &Heading {
        &self.heading
    }

    /// Whether no sample has begun that was not handed over.
    pub fn is_empty(&self) -> bool {
        self.samples.is_empty()
    }

    /// How many samples every body has.
    pub fn whole_samples(&self) -> usize {
        self.samples.len() - usize::from(self.next > 0)
    }

    /// Whether no body lacks what another has.
    pub fn is_between_samples(&self) -> bool {
        self.next == 0
    }

    /// Moves what is whole to the empty buffers of `samples`. The file has ended if a sample is not: it is dropped.
    pub fn hand_over(&mut self, samples: &mut Samples) {
        let whole = self.whole_samples();
        let columns = self.samples.bodies.iter_mut().flat_map(BodySamples::columns_mut);
        columns.for_each(|column| column.truncate(whole));
        self.samples.times_s.truncate(whole);
        std::mem::swap(&mut self.samples.times_s, &mut samples.times_s);
        std::mem::swap(&mut self.samples.bodies, &mut samples.bodies);
        self.next = 0;
    }

    /// Takes a record in.
    pub fn take(&mut self, opcode: u8, body: &[u8]) -> McapResult<()> {
        if opcode == op::ATTACHMENT {
            let (name, _, data) = attachment(body).ok_or(McapError::UnexpectedEof)?;
            if std::path::Path::new(&name).extension().is_some_and(|extension| extension == "toml") {
                self.heading.scene = Some(String::from_utf8_lossy(data).into_owned());
            }
            return Ok(());
        }
        match parse(opcode, body)? {
            Record::Metadata(metadata) if metadata.name == "polhode" => self.take_facts(metadata),
            Record::Schema { header, data } => {
                let is_protobuf = header.encoding == "protobuf";
                let described = is_protobuf.then(|| state::channels_of(&data)).flatten();
                self.schemas.insert(header.id, (header.name, described));
            }
            Record::Channel(topic) => self.take_topic(&topic)?,
            Record::Message { header, data } => self.take_message(&header, &data)?,
            _ => {}
        }
        Ok(())
    }

    fn take_facts(&mut self, metadata: Metadata) {
        self.heading.provenance = metadata.metadata.into_iter().collect();
    }

    /// A file repeats its topics at its end; a new one after the first sample would lack that one.
    fn take_topic(&mut self, topic: &Topic) -> McapResult<()> {
        let Some((schema, described)) = self.schemas.get(&topic.schema_id) else { return Ok(()) };
        let name = topic.topic.strip_prefix("/body/").and_then(|rest| rest.strip_suffix("/state"));
        if (schema != state::NAME && name.is_none()) || self.topics.contains_key(&topic.id) {
            return Ok(());
        }
        let refuse = |reason: &str| Err(wrong(format!("topic {}: {reason}", topic.topic)));
        let Some(name) = name else { return refuse("states are on /body/<name>/state") };
        let (true, Some(described), "protobuf") = (schema == state::NAME, described, &*topic.message_encoding) else {
            return refuse("its schema is not the polhode.BodyState that this version knows");
        };
        if self.has_begun {
            return refuse("it begins after the first sample");
        }
        if self.heading.bodies.iter().any(|body| body.name == name) {
            return refuse("there are two of that name");
        }
        let channels: Vec<_> =
            Channel::ALL.into_iter().filter(|channel| topic.metadata.contains_key(channel.row().name)).collect();
        if channels.len() != topic.metadata.len() {
            return refuse("its metadata names a channel that this version does not know");
        }
        if !channels.iter().all(|channel| described.contains(channel)) {
            return refuse("its metadata names a channel that its schema does not describe");
        }
        self.topics.insert(topic.id, self.layouts.len());
        self.layouts.push(StateLayout::new(&channels));
        self.samples.bodies.push(BodySamples::new(&channels));
        let certificate = certificate(&self.heading.provenance, name);
        self.heading.bodies.push(RecordedBody { name: name.into(), channels, certificate });
        Ok(())
    }

    fn take_message(&mut self, header: &MessageHeader, data: &[u8]) -> McapResult<()> {
        let Some(body) = self.topics.get(&header.channel_id).copied() else { return Ok(()) };
        let refuse = |reason: &str| {
            let time = header.log_time;
            Err(wrong(format!("the state of body {} at {time} ns {reason}", self.heading.bodies[body].name)))
        };
        if body != self.next {
            return refuse("is out of turn: each sample has one of every body, in the order of the topics");
        }
        let columns = self.samples.bodies[body].columns_mut();
        let Some(time_s) = self.layouts[body].decode(data, columns) else {
            return refuse("has another form than its schema and its topic's metadata say");
        };
        if header.log_time.cast_signed() != nanoseconds(time_s) || header.publish_time != header.log_time {
            return refuse("is stamped with another time than it holds");
        }
        match self.samples.times_s.last() {
            Some(time) if body > 0 && time.to_bits() != time_s.to_bits() => {
                return refuse("is at another time than that of the body before");
            }
            _ if body == 0 => self.samples.times_s.push(time_s),
            _ => {}
        }
        self.has_begun = true;
        self.next = (body + 1) % self.layouts.len();
        Ok(())
    }
}

fn wrong(reason: String) -> McapError {
    McapError::Io(Error::other(reason))
}
