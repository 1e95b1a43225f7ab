//! Messages as they come from the wire: either byte order, no stamps, the wrong order, another form.

use std::collections::BTreeMap;
use std::fs;

use mcap::records::MessageHeader;
use polhode::recording::foreign::{Mapping, Observation, observe};
use polhode::recording::{Axes, RecordingError};
use tempfile::tempdir;

const TRANSFORM: &str = "geometry_msgs/msg/TransformStamped";

/// Plain CDR, written as the standard says it.
struct Cdr {
    bytes: Vec<u8>,
    is_big: bool,
}

impl Cdr {
    fn new(is_big: bool) -> Self {
        Self { bytes: Vec::from([0, u8::from(!is_big), 0, 0]), is_big }
    }

    fn aligned(&mut self, size: usize) {
        let length = (self.bytes.len() - 4).next_multiple_of(size) + 4;
        self.bytes.resize(length, 0xee);
    }

    fn word(mut self, value: u32) -> Self {
        self.aligned(4);
        self.bytes.extend(if self.is_big { value.to_be_bytes() } else { value.to_le_bytes() });
        self
    }

    fn text(self, text: &str) -> Self {
        let mut cdr = self.word(u32::try_from(text.len() + 1).expect("short"));
        cdr.bytes.extend(text.bytes());
        cdr.bytes.push(0);
        cdr
    }

    fn doubles(mut self, values: &[f64]) -> Self {
        for value in values {
            self.aligned(8);
            self.bytes.extend(if self.is_big { value.to_be_bytes() } else { value.to_le_bytes() });
        }
        self
    }
}

/// A frame at x = `x`, turned by half a turn about z.
fn transform(stamp_ns: u32, child: &str, x: f64, is_big: bool) -> Vec<u8> {
    let header = Cdr::new(is_big).word(0).word(stamp_ns).text("world");
    header.text(child).doubles(&[x, 2.0, 3.0, 0.0, 0.0, 1.0, 0.0]).bytes
}

/// An IMU's rates about z; what has a covariance of −1 is not measured.
fn imu(stamp_ns: u32, covariances: [f64; 2]) -> Vec<u8> {
    let mut numbers = vec![0.0, 0.0, 0.0, 1.0, covariances[0]];
    numbers.extend([0.0; 8]);
    numbers.extend([0.0, 0.0, 4.0, covariances[1]]);
    numbers.extend([0.0; 8 + 12]);
    Cdr::new(false).word(0).word(stamp_ns).text("imu").doubles(&numbers).bytes
}

type Sent = (&'static str, &'static str, u64, Vec<u8>);

/// Topic, schema, log time and message of each, in a file as another program may write it.
fn read(messages: &[Sent]) -> Result<Observation, RecordingError> {
    read_as(["ros2idl", "cdr"], messages)
}

fn read_protobuf(messages: &[Sent]) -> Result<Observation, RecordingError> {
    read_as(["protobuf", "protobuf"], messages)
}

/// The encodings of schemas and of messages.
fn read_as(encodings: [&str; 2], messages: &[Sent]) -> Result<Observation, RecordingError> {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("bag.mcap");
    let mut writer = mcap::Writer::new(fs::File::create(&path).expect("room")).expect("room");
    for (topic, schema, log_time, message) in messages {
        let schema = writer.add_schema(schema, encodings[0], b"struct").expect("room");
        let channel_id = writer.add_channel(schema, topic, encodings[1], &BTreeMap::new()).expect("room");
        let header = MessageHeader { channel_id, sequence: 0, log_time: *log_time, publish_time: *log_time };
        writer.write_to_known_channel(&header, message).expect("room");
    }
    writer.finish().expect("room");
    observe(&path, &Mapping::default())
}

#[test]
fn either_byte_order_says_the_same() {
    let sent = |is_big| -> Vec<Sent> {
        let message = |stamp| transform(stamp, "base", f64::from(stamp), is_big);
        vec![("/tf", TRANSFORM, 5, message(10)), ("/tf", TRANSFORM, 6, message(20))]
    };
    let found = [true, false].map(|is_big| read(&sent(is_big)).expect("told"));
    assert_eq!(found[0], found[1]);
    let body = &found[0].bodies[0];
    let attitude = body.attitude.as_ref().expect("told");
    assert_eq!((body.name.as_str(), attitude.times_s.as_slice()), ("base", [1e-8, 2e-8].as_slice()));
    assert_eq!(attitude.columns.each_ref().map(|column| column[0]), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(body.position.as_ref().expect("told").columns[0], [10.0, 20.0]);
}

#[test]
fn messages_without_stamps_have_the_times_of_their_recording() {
    let message = || transform(0, "base", 1.0, false);
    let found = read(&[("/tf", TRANSFORM, 7, message()), ("/tf", TRANSFORM, 9, message())]).expect("told");
    assert_eq!(found.bodies[0].attitude.as_ref().expect("told").times_s, [7e-9, 9e-9]);
}

#[test]
fn what_an_imu_does_not_measure_is_left_out() {
    let kind = "sensor_msgs/msg/Imu";
    let sent = |covariances| [("/imu", kind, 1, imu(10, covariances)), ("/imu", kind, 2, imu(20, covariances))];
    let both = read(&sent([0.0, 0.0])).expect("told");
    assert!(both.bodies[0].attitude.is_some());
    let rates = both.bodies[0].angular_velocity.as_ref().expect("told");
    assert_eq!((rates.axes, rates.columns[2].as_slice()), (Some(Axes::Body), [4.0, 4.0].as_slice()));
    let found = read(&sent([-1.0, 0.0])).expect("told");
    assert!(found.bodies[0].attitude.is_none() && found.bodies[0].angular_velocity.is_some());
    assert_eq!(found.bodies[0].name, "/imu");
}

/// As with two estimates of one pose.
#[test]
fn a_frame_in_two_others_is_two_bodies() {
    let in_odom = |stamp| {
        let header = Cdr::new(false).word(0).word(stamp).text("odom");
        header.text("base").doubles(&[1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0]).bytes
    };
    let mut sent = Vec::new();
    for stamp in [10, 20] {
        sent.push(("/tf", TRANSFORM, 1, transform(stamp, "base", 0.0, false)));
        sent.push(("/tf", TRANSFORM, 1, in_odom(stamp)));
    }
    let names: Vec<_> = read(&sent).expect("told").bodies.into_iter().map(|body| body.name).collect();
    assert_eq!(names, ["base in world", "base in odom"]);
}

#[test]
fn repeated_transforms_are_one() {
    let sent = [10, 10, 20].map(|stamp| ("/tf", TRANSFORM, 1, transform(stamp, "base", f64::from(stamp), false)));
    assert_eq!(read(&sent).expect("told").bodies[0].attitude.as_ref().expect("told").times_s, [1e-8, 2e-8]);
}

#[test]
fn what_tells_nothing_is_no_body() {
    // A parent and a child, and neither a translation nor a rotation.
    let bare = b"\x12\x01a\x1a\x01b".to_vec();
    let refused = read_protobuf(&[("/tf", "foxglove.FrameTransform", 1, bare)]).expect_err("no body").to_string();
    assert!(refused.contains("nothing in it tells of a body's attitude or rates"), "{refused}");
}

/// 4 kB that would become gigabytes: every pose of a list repeats the name of the frame.
#[test]
fn a_name_that_many_poses_repeat_is_short() {
    let poses = |length: u16| {
        let [low, high] =
            [length % 128 + 128, length / 128].map(|seven_bits| u8::try_from(seven_bits).expect("a byte"));
        let mut message = vec![0x12, low, high];
        message.extend(vec![b'a'; length.into()]);
        message.extend([0x1a, 0].repeat(3));
        message.extend(b"\x1a\x0b\x0a\x09\x09\0\0\0\0\0\0\0\0");
        [("/poses", "foxglove.PosesInFrame", 1, message)]
    };
    assert_eq!(read_protobuf(&poses(1024)).expect("one pose with a position").bodies.len(), 1);
    let refused = read_protobuf(&poses(1025)).expect_err("too long").to_string();
    assert!(refused.contains("has another form than foxglove.PosesInFrame has, or no end of bodies"), "{refused}");
}

/// Seconds from 0 have steps of 256 ns after 36 years.
#[test]
fn times_that_seconds_cannot_tell_apart_are_refused() {
    let sent = |last_ns| -> Vec<Sent> {
        let stamps = [5, 1 << 60, last_ns];
        stamps.map(|stamp| ("/tf", TRANSFORM, stamp, transform(0, "base", 0.0, false))).into()
    };
    let times = read(&sent((1 << 60) + 1000)).expect("told").bodies[0].attitude.as_ref().expect("told").times_s.clone();
    assert!(times[1] < times[2]);
    let refused = read(&sent((1 << 60) + 1)).expect_err("one time").to_string();
    assert!(refused.contains("both are one f64 of seconds"), "{refused}");
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    let whole = transform(30, "base", 1.0, false);
    let mut claims_much = whole.clone();
    claims_much[12..16].copy_from_slice(&u32::MAX.to_le_bytes());
    let mut is_longer = whole.clone();
    is_longer.extend([0; 8]);
    let mut is_parameter_list = whole.clone();
    is_parameter_list[1] = 3;
    let earlier = transform(20, "base", 1.0, false);
    let other = transform(30, "base", 2.0, false);
    let nan = transform(40, "base", f64::NAN, false);
    let many = Cdr::new(false).word(u32::MAX).bytes;
    let form =
        "the message on /tf at 9 ns has another form than geometry_msgs/msg/TransformStamped has, or no end of bodies";
    let cases = [
        (TRANSFORM, whole[..whole.len() - 1].to_vec(), form),
        (TRANSFORM, Vec::new(), form),
        (TRANSFORM, claims_much, form),
        (TRANSFORM, is_longer, form),
        (TRANSFORM, is_parameter_list, form),
        (TRANSFORM, earlier, "the attitude of \"base\" is told at 20 ns after 30 ns: times ascend"),
        (TRANSFORM, other, "is told at 30 ns after 30 ns"),
        (TRANSFORM, nan, "the message on /tf at 9 ns is refused: the position of \"base\" is not finite"),
        ("tf2_msgs/msg/TFMessage", many, "has another form than tf2_msgs/msg/TFMessage has"),
    ];
    for (schema, message, expected) in cases {
        let refused = read(&[("/first", TRANSFORM, 1, whole.clone()), ("/tf", schema, 9, message)]);
        let refused = refused.expect_err(expected).to_string();
        assert!(refused.contains(expected) && refused.contains("bag.mcap"), "{refused}");
    }
    let unknown = read(&[("/scan", "sensor_msgs/msg/LaserScan", 1, whole)]).expect_err("no body").to_string();
    assert!(unknown.contains("there are topics of sensor_msgs/msg/LaserScan (cdr)"), "{unknown}");
}
