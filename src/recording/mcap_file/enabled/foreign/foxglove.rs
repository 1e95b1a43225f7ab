//! Messages of Foxglove's schemas, whatever they are encoded in. A test holds names, numbers and types against
//! Foxglove's own descriptors where this crate has them.

use prost::Message;

use super::super::foxglove::{FrameTransform, Pose, Quaternion, Timestamp, Xyz};
use crate::recording::foreign::gathering::{MOST_BODIES, Place, Statement};

/// Longest name of a frame that many poses have, bytes.
const LONGEST_NAME: usize = 1024;

#[derive(Clone, PartialEq, Message)]
pub(super) struct FrameTransforms {
    #[prost(message, repeated, tag = "1")]
    pub transforms: Vec<FrameTransform>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct PoseInFrame {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    pub frame_id: String,
    #[prost(message, optional, tag = "3")]
    pub pose: Option<Pose>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct PosesInFrame {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    pub frame_id: String,
    #[prost(message, repeated, tag = "3")]
    pub poses: Vec<Pose>,
}

/// Velocities are in the axes of the body.
#[derive(Clone, PartialEq, Message)]
pub(super) struct Odometry {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    pub frame_id: String,
    #[prost(string, tag = "3")]
    pub body_frame_id: String,
    #[prost(message, optional, tag = "4")]
    pub pose: Option<Pose>,
    #[prost(message, optional, tag = "5")]
    pub linear_velocity: Option<Xyz>,
    #[prost(message, optional, tag = "6")]
    pub angular_velocity: Option<Xyz>,
}

/// What a message says.
pub(super) trait Says {
    /// Whether what it says takes no more room than a few of it.
    fn is_bounded(&self) -> bool {
        true
    }

    fn say(self, said: &mut Vec<Statement>);
}

impl Says for FrameTransforms {
    fn say(self, said: &mut Vec<Statement>) {
        self.transforms.into_iter().for_each(|transform| transform.say(said));
    }
}

impl Says for FrameTransform {
    fn say(self, said: &mut Vec<Statement>) {
        said.push(Statement {
            stamp_ns: self.timestamp.map(nanoseconds),
            position: self.translation.map(vector),
            attitude: self.rotation.map(quaternion),
            place: Place::transform(self.parent_frame_id, self.child_frame_id),
            ..Statement::default()
        });
    }
}

impl Says for PoseInFrame {
    fn say(self, said: &mut Vec<Statement>) {
        let place = Place { fixed: Some(self.frame_id), ..Place::default() };
        said.push(of_pose(place, self.timestamp, self.pose));
    }
}

impl Says for PosesInFrame {
    /// Every pose repeats the name of the frame.
    fn is_bounded(&self) -> bool {
        self.poses.len() <= MOST_BODIES && self.frame_id.len() <= LONGEST_NAME
    }

    /// The places in the list tell the bodies apart.
    fn say(self, said: &mut Vec<Statement>) {
        for (number, pose) in self.poses.into_iter().enumerate() {
            let place = Place { topic: format!("[{number}]"), fixed: Some(self.frame_id.clone()), ..Place::default() };
            said.push(of_pose(place, self.timestamp, Some(pose)));
        }
    }
}

impl Says for Odometry {
    fn say(self, said: &mut Vec<Statement>) {
        let place = Place {
            fixed: Some(self.frame_id),
            moving: Some(self.body_frame_id.clone()),
            axes: Some(self.body_frame_id),
            ..Place::default()
        };
        said.push(Statement {
            velocity: self.linear_velocity.map(vector),
            angular_velocity: self.angular_velocity.map(vector),
            ..of_pose(place, self.timestamp, self.pose)
        });
    }
}

fn of_pose(place: Place, timestamp: Option<Timestamp>, pose: Option<Pose>) -> Statement {
    Statement {
        place,
        stamp_ns: timestamp.map(nanoseconds),
        attitude: pose.and_then(|pose| pose.orientation).map(quaternion),
        position: pose.and_then(|pose| pose.position).map(vector),
        ..Statement::default()
    }
}

fn nanoseconds(timestamp: Timestamp) -> i64 {
    timestamp.seconds.saturating_mul(1_000_000_000).saturating_add(timestamp.nanos.into())
}

fn quaternion(rotation: Quaternion) -> [f64; 4] {
    [rotation.w, rotation.x, rotation.y, rotation.z]
}

fn vector(vector: Xyz) -> [f64; 3] {
    [vector.x, vector.y, vector.z]
}
