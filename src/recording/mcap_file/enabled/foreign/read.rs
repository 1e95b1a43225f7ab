use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::{BufReader, Error};
use std::path::Path;

use mcap::records::{Channel as Topic, MessageHeader, Record, op};
use mcap::{McapError, McapResult};

use super::super::parse::parse;
use super::super::read::refused;
use super::super::scan::Records;
use super::super::state;
use super::kinds::{self, Reader};
use crate::recording::RecordingError;
use crate::recording::foreign::gathering::{Gathering, Statement};
use crate::recording::foreign::{Mapping, Observation};
use crate::recording::format::is_part;

/// Longest message that is taken apart, bytes: some encodings tell a pose, or nothing, in two.
const LONGEST: usize = 1 << 20;

/// Reads what an `.mcap` says of bodies; `None` if this crate wrote it and the mapping asks for no frame: its own
/// messages say more than the pictures beside them.
///
/// # Errors
/// If it cannot be read, is damaged, or tells of no body that is asked for.
pub(in crate::recording) fn observe(path: &Path, mapping: &Mapping) -> Result<Option<Observation>, RecordingError> {
    let io_error = |source| RecordingError::Io { attempt: "read", path: path.into(), source };
    let file = BufReader::with_capacity(1 << 16, File::open(path).map_err(io_error)?);
    let mut records = Records::begin(file).map_err(|error| refused(path, error, "at the start"))?;
    let mut intake = Intake::default();
    let mut gathering = Gathering::new(mapping);
    loop {
        match records.advance(|opcode, body| intake.take(opcode, body, &mut gathering)) {
            Ok(true) if intake.is_own && mapping.frame.is_none() => return Ok(None),
            Ok(true) => {}
            Ok(false) => break,
            Err(McapError::UnexpectedEof) if is_part(path) => break,
            Err(error) => {
                let place = format!("before byte {}", records.bytes_read());
                return Err(refused(path, error, &place));
            }
        }
    }
    if gathering.is_empty() {
        let kinds = Vec::from_iter(intake.unknown).join(", ");
        let kinds = if kinds.is_empty() { "no topics".to_owned() } else { format!("topics of {kinds}") };
        let reason = format!("nothing in it tells of a body's attitude or rates: there are {kinds}");
        return Err(RecordingError::Decode { path: path.into(), reason });
    }
    let observation = gathering.observation();
    observation.map(Some).map_err(|reason| RecordingError::Decode { path: path.into(), reason })
}

/// What the records of a file bring.
#[derive(Default)]
struct Intake {
    /// Names by number.
    schemas: BTreeMap<u16, String>,
    topics: BTreeMap<u16, Known>,
    /// What is not read: encodings and names of schemas.
    unknown: BTreeSet<String>,
    said: Vec<Statement>,
    is_own: bool,
}

/// A topic that is read.
struct Known {
    topic: String,
    schema: String,
    resolution: f64,
    read: Reader,
}

impl Intake {
    fn take(&mut self, opcode: u8, body: &[u8], gathering: &mut Gathering) -> McapResult<()> {
        if opcode == op::ATTACHMENT {
            return Ok(());
        }
        match parse(opcode, body)? {
            Record::Schema { header, .. } => {
                self.is_own |= header.name == state::NAME;
                self.schemas.insert(header.id, header.name);
            }
            Record::Channel(topic) => self.take_topic(topic),
            Record::Message { header, data } => self.take_message(&header, &data, gathering)?,
            _ => {}
        }
        Ok(())
    }

    fn take_topic(&mut self, topic: Topic) {
        let schema = self.schemas.get(&topic.schema_id).cloned().unwrap_or_default();
        let encoding = topic.message_encoding.as_str();
        match kinds::reader(encoding, &schema) {
            Some(read) => {
                let known = Known { topic: topic.topic, read, resolution: kinds::resolution(encoding), schema };
                self.topics.insert(topic.id, known);
            }
            None => {
                self.unknown.insert(format!("{schema} ({encoding})"));
            }
        }
    }

    fn take_message(&mut self, header: &MessageHeader, data: &[u8], gathering: &mut Gathering) -> McapResult<()> {
        let Some(known) = self.topics.get(&header.channel_id) else { return Ok(()) };
        let wrong = |reason: String| {
            let reason = format!("the message on {} at {} ns {reason}", known.topic, header.log_time);
            McapError::Io(Error::other(reason))
        };
        if data.len() > LONGEST {
            return Err(wrong(format!("has {} bytes, more than {LONGEST}", data.len())));
        }
        self.said.clear();
        (known.read)(data, &mut self.said)
            .ok_or_else(|| wrong(format!("has another form than {} has, or no end of bodies", known.schema)))?;
        for mut statement in self.said.drain(..) {
            if !statement.place.is_on_any_topic {
                // Before its place in a list, if it has one.
                statement.place.topic.insert_str(0, &known.topic);
            }
            statement.log_ns = header.log_time.cast_signed();
            statement.resolution = known.resolution;
            gathering.take(&statement).map_err(|reason| wrong(format!("is refused: {reason}")))?;
        }
        Ok(())
    }
}
