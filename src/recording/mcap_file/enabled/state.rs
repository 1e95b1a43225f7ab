//! `polhode.BodyState`: one message a sample and body, every number an f64. Written by hand, as it is nearly all of the
//! file and all of the time; a test holds the bytes against those of a derived encoder.

use prost::Message;
use prost::encoding::{WireType, encode_key, encode_varint};

use super::descriptor::{FieldDescriptor, FileDescriptor, FileDescriptorSet, MessageDescriptor};
use super::template::{Stamp, Template};
use crate::scenario::nanoseconds;
use crate::telemetry::Channel;

/// Full name of the message.
pub(super) const NAME: &str = "polhode.BodyState";
/// Field of the exact time in s.
const TIME: u32 = 1;
/// Its key on the wire: the field, of eight bytes.
const TIME_KEY: u8 = (TIME << 3 | 1).to_le_bytes()[0];
/// Field of the time in whole ns, as `google.protobuf.Timestamp`: what the message is stamped with.
const TIMESTAMP: u32 = 2;
/// Its key on the wire: the field, length first.
const TIMESTAMP_KEY: u8 = (TIMESTAMP << 3 | 2).to_le_bytes()[0];
/// Field of the first channel; the others follow in the order of [`Channel`], which only ever grows at its end.
const FIRST_CHANNEL: u32 = 3;

/// How many channels every recording describes, recorded or not; of those after them, only what it holds.
const ALWAYS_DESCRIBED: usize = 19;

/// Field of `channel`.
fn field_of(channel: Channel) -> u32 {
    FIRST_CHANNEL + channel as u32
}

/// How messages of one body's channels are laid out.
#[derive(Debug)]
pub(super) struct StateLayout {
    /// What follows the times: keys, and room for each column's number.
    channels: Template,
}

/// The times of a sample as the messages of all bodies begin with them.
#[derive(Debug)]
pub(super) struct StateTimes {
    time_s: [u8; 9],
    stamp: Stamp,
}

impl StateTimes {
    pub fn new(time_s: f64, stamp_ns: i64) -> Self {
        let mut field = [TIME_KEY; 9];
        field[1..].copy_from_slice(&time_s.to_le_bytes());
        Self { time_s: field, stamp: Stamp::new(TIMESTAMP_KEY, stamp_ns) }
    }

    fn append(&self, bytes: &mut Vec<u8>) {
        bytes.extend_from_slice(&self.time_s);
        bytes.extend_from_slice(self.stamp.bytes());
    }
}

impl StateLayout {
    pub fn new(channels: &[Channel]) -> Self {
        let mut template = Template::default();
        channels.iter().flat_map(|channel| keys_of(*channel)).for_each(|key| template.push(&key));
        Self { channels: template }
    }

    /// Appends sample `index` to `bytes`.
    pub fn encode(&self, times: &StateTimes, columns: &[Vec<f64>], index: usize, bytes: &mut Vec<u8>) {
        times.append(bytes);
        self.channels.append(columns.iter().map(|column| column[index]), bytes);
    }

    /// Appends the numbers of a message to `columns` and returns its exact time in s; `None`, and nothing is appended,
    /// if it is not laid out just so.
    pub fn decode(&self, message: &[u8], columns: &mut [Vec<f64>]) -> Option<f64> {
        let time_s = number_at(message, 1)?;
        let times = StateTimes::new(time_s, nanoseconds(time_s));
        let channels = message.strip_prefix(&times.time_s)?.strip_prefix(times.stamp.bytes())?;
        if channels.len() != self.channels.len() {
            return None;
        }
        let (mut end, expected) = (0, self.channels.bytes());
        for place in self.channels.places() {
            if channels.get(end..*place) != expected.get(end..*place) {
                return None;
            }
            end = *place + 8;
        }
        for (place, column) in self.channels.places().iter().zip(columns) {
            column.push(number_at(channels, *place)?);
        }
        Some(time_s)
    }
}

fn number_at(bytes: &[u8], place: usize) -> Option<f64> {
    Some(f64::from_le_bytes(*bytes.get(place..)?.first_chunk()?))
}

fn keys_of(channel: Channel) -> Vec<Vec<u8>> {
    let width = channel.width();
    let mut keys = vec![Vec::new(); width];
    if width == 1 {
        encode_key(field_of(channel), WireType::SixtyFourBit, &mut keys[0]);
        return keys;
    }
    encode_key(field_of(channel), WireType::LengthDelimited, &mut keys[0]);
    // Each number of the sub-message: one byte of key, eight of f64.
    encode_varint(9 * width as u64, &mut keys[0]);
    for (key, component) in keys.iter_mut().zip(1..) {
        encode_key(component, WireType::SixtyFourBit, key);
    }
    keys
}

/// The channels described in a file of bodies with channels `recorded`: the first of the table always, as recordings have
/// always done, and of the others what is there.
pub(super) fn described(recorded: &[Channel]) -> Vec<Channel> {
    let is_described = |(number, channel): &(usize, Channel)| *number < ALWAYS_DESCRIBED || recorded.contains(channel);
    Channel::ALL.into_iter().enumerate().filter(is_described).map(|(_, channel)| channel).collect()
}

/// The channels that `schema` describes, if it is one that this crate embeds.
pub(super) fn channels_of(schema: &[u8]) -> Option<Vec<Channel>> {
    let set = FileDescriptorSet::decode(schema).ok()?;
    let message = set.file.get(1)?.message_type.first()?;
    let named: Vec<_> = message.field.iter().filter_map(|field| Channel::from_name(&field.name)).collect();
    let channels = described(&named);
    (descriptor(&channels) == schema).then_some(channels)
}

/// The `FileDescriptorSet` of [`NAME`] with these channels, and with everything it refers to.
pub(super) fn descriptor(channels: &[Channel]) -> Vec<u8> {
    let timestamp = FileDescriptor {
        name: "google/protobuf/timestamp.proto".into(),
        package: "google.protobuf".into(),
        message_type: vec![
            MessageDescriptor::new("Timestamp")
                .with(FieldDescriptor::int64("seconds", 1))
                .with(FieldDescriptor::int32("nanos", 2)),
        ],
        syntax: "proto3".into(),
        ..FileDescriptor::default()
    };
    let polhode = FileDescriptor {
        name: "polhode.proto".into(),
        package: "polhode".into(),
        dependency: vec![timestamp.name.clone()],
        message_type: [body_state(channels)].into_iter().chain(tuples(channels)).collect(),
        syntax: "proto3".into(),
    };
    FileDescriptorSet { file: vec![timestamp, polhode] }.encode_to_vec()
}

fn body_state(channels: &[Channel]) -> MessageDescriptor {
    let start = MessageDescriptor::new("BodyState")
        .with(FieldDescriptor::double("time_s", TIME.cast_signed()))
        .with(FieldDescriptor::message("timestamp", TIMESTAMP.cast_signed(), ".google.protobuf.Timestamp"));
    channels.iter().fold(start, |descriptor, channel| {
        let (name, number) = (channel.row().name, field_of(*channel).cast_signed());
        match message_of(*channel) {
            None => descriptor.with_optional(FieldDescriptor::double(name, number)),
            Some(message) => descriptor.with(FieldDescriptor::message(name, number, &format!(".polhode.{message}"))),
        }
    })
}

/// What carries the components of `channel`; a scalar needs nothing.
fn message_of(channel: Channel) -> Option<&'static str> {
    match channel.row().components {
        ["w", "x", "y", "z"] => Some("Quaternion"),
        ["first", "second", "third"] => Some("EulerAngles"),
        ["precession", "nutation", "spin"] => Some("FigureAngles"),
        [_] => None,
        _ => Some("Vector3"),
    }
}

/// The messages that carry components: quaternion and vector always, as recordings have always done.
fn tuples(channels: &[Channel]) -> Vec<MessageDescriptor> {
    let always = [Channel::Attitude, Channel::AngularVelocity];
    let mut tuples: Vec<MessageDescriptor> = Vec::new();
    for channel in always.iter().chain(channels) {
        let Some(name) = message_of(*channel) else { continue };
        if tuples.iter().all(|tuple| tuple.name != name) {
            let fields = channel.row().components.iter().zip(1..);
            let tuple = |tuple: MessageDescriptor, (component, number): (&&str, i32)| {
                tuple.with(FieldDescriptor::double(component, number))
            };
            tuples.push(fields.fold(MessageDescriptor::new(name), tuple));
        }
    }
    tuples
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The fields of message `name` as a `.proto` says them: type, name, number.
    fn fields(file: &FileDescriptor, name: &str) -> Vec<String> {
        let message = file.message_type.iter().find(|message| message.name == name).expect("described");
        let field = |field: &FieldDescriptor| {
            let kind = field.type_name.as_deref().unwrap_or("double");
            let kind = kind.trim_start_matches(".polhode").trim_start_matches('.');
            let optional = if field.proto3_optional == Some(true) { "optional " } else { "" };
            format!("{optional}{kind} {} = {};", field.name, field.number)
        };
        message.field.iter().map(field).collect()
    }

    /// Fails when a channel is added: then add its line. It never fails because a number changed its meaning.
    #[test]
    fn the_proto_file_says_what_is_embedded() {
        let set = FileDescriptorSet::decode(&*descriptor(&Channel::ALL)).expect("a descriptor");
        let proto = include_str!("../schemas/polhode.proto");
        for name in ["BodyState", "Quaternion", "Vector3", "EulerAngles", "FigureAngles"] {
            let (_, rest) = proto.split_once(&format!("message {name} {{")).expect("in the file");
            let (body, _) = rest.split_once('}').expect("closed");
            let written: Vec<_> = body.lines().filter_map(|line| Some(line.split_once(';')?.0.trim())).collect();
            let embedded = fields(&set.file[1], name);
            assert_eq!(written.iter().map(|line| format!("{line};")).collect::<Vec<_>>(), embedded);
        }
    }

    /// What was recorded before a channel was thought of is described as it was then.
    #[test]
    fn a_schema_is_known_by_the_channels_in_it() {
        let plain = described(&[Channel::Attitude]);
        assert_eq!(plain, described(&[]));
        assert_eq!(plain.len(), ALWAYS_DESCRIBED);
        assert_eq!(channels_of(&descriptor(&plain)), Some(plain.clone()));
        let more = described(&[Channel::PolhodePhase, Channel::EulerZyx]);
        assert_eq!(more.len(), plain.len() + 2);
        assert_eq!(channels_of(&descriptor(&more)), Some(more.clone()));
        assert_eq!(channels_of(&descriptor(&more[1..])), None);
        assert_eq!(channels_of(b"no schema"), None);
    }
}
