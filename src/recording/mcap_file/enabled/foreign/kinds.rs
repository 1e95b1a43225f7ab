use prost::Message;

use super::super::foxglove::FrameTransform;
use super::cdr::Cdr;
use super::foxglove::{FrameTransforms, Odometry, PoseInFrame, PosesInFrame, Says};
use super::json::FromJson;
use super::ros;
use crate::recording::foreign::gathering::Statement;

/// Reads a message of one kind: what it says, or `None` if it is laid out in another way than its schema says, or says so
/// much that it cannot be meant.
pub(super) type Reader = fn(&[u8], &mut Vec<Statement>) -> Option<()>;

/// How the messages of a topic are read, by what encodes them and the name of their schema; `None` if they say nothing
/// of bodies that turn, or this program does not know them.
pub(super) fn reader(encoding: &str, schema: &str) -> Option<Reader> {
    let reader: Reader = match (encoding, schema) {
        ("protobuf", "foxglove.FrameTransforms") => protobuf::<FrameTransforms>,
        ("protobuf", "foxglove.FrameTransform") => protobuf::<FrameTransform>,
        ("protobuf", "foxglove.PoseInFrame") => protobuf::<PoseInFrame>,
        ("protobuf", "foxglove.PosesInFrame") => protobuf::<PosesInFrame>,
        ("protobuf", "foxglove.Odometry") => protobuf::<Odometry>,
        ("json", "foxglove.FrameTransforms") => json::<FrameTransforms>,
        ("json", "foxglove.FrameTransform") => json::<FrameTransform>,
        ("json", "foxglove.PoseInFrame") => json::<PoseInFrame>,
        ("json", "foxglove.PosesInFrame") => json::<PosesInFrame>,
        ("json", "foxglove.Odometry") => json::<Odometry>,
        ("cdr", "tf2_msgs/msg/TFMessage") => |bytes, said| cdr(bytes, said, ros::transforms),
        ("cdr", "geometry_msgs/msg/TransformStamped") => |bytes, said| cdr(bytes, said, ros::transform),
        ("cdr", "geometry_msgs/msg/PoseStamped") => |bytes, said| cdr(bytes, said, ros::pose),
        ("cdr", "geometry_msgs/msg/PoseWithCovarianceStamped") => {
            |bytes, said| cdr(bytes, said, ros::pose_with_covariance)
        }
        ("cdr", "geometry_msgs/msg/TwistStamped") => |bytes, said| cdr(bytes, said, ros::twist),
        ("cdr", "geometry_msgs/msg/TwistWithCovarianceStamped") => {
            |bytes, said| cdr(bytes, said, ros::twist_with_covariance)
        }
        ("cdr", "geometry_msgs/msg/WrenchStamped") => |bytes, said| cdr(bytes, said, ros::wrench),
        ("cdr", "sensor_msgs/msg/Imu") => |bytes, said| cdr(bytes, said, ros::imu),
        ("cdr", "nav_msgs/msg/Odometry") => |bytes, said| cdr(bytes, said, ros::odometry),
        _ => return None,
    };
    Some(reader)
}

/// Half a unit in the last place of what this encoding keeps: the parser of JSON may miss the nearest f64 by one.
pub(super) fn resolution(encoding: &str) -> f64 {
    if encoding == "json" { f64::EPSILON } else { f64::EPSILON / 2.0 }
}

fn protobuf<M: Message + Default + Says>(bytes: &[u8], said: &mut Vec<Statement>) -> Option<()> {
    say(M::decode(bytes).ok()?, said)
}

fn json<M: FromJson + Says>(bytes: &[u8], said: &mut Vec<Statement>) -> Option<()> {
    say(M::from_json(&serde_json::from_slice(bytes).ok()?)?, said)
}

fn say<M: Says>(message: M, said: &mut Vec<Statement>) -> Option<()> {
    message.is_bounded().then(|| message.say(said))
}

fn cdr(bytes: &[u8], said: &mut Vec<Statement>, read: fn(&mut Cdr, &mut Vec<Statement>) -> Option<()>) -> Option<()> {
    let mut cdr = Cdr::of(bytes)?;
    read(&mut cdr, said)?;
    cdr.is_at_end().then_some(())
}
