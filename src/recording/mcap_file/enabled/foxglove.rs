//! The messages of Foxglove's schemas that are written here, as far as they are used. A test holds names, numbers and
//! types against Foxglove's own descriptors.

use nalgebra::{UnitQuaternion, Vector3};
use prost::Message;

/// Name and descriptor of `foxglove.FrameTransforms`.
pub(super) const FRAME_TRANSFORMS: (&str, &[u8]) =
    ("foxglove.FrameTransforms", include_bytes!("../schemas/FrameTransforms.bin"));
/// Name and descriptor of `foxglove.SceneUpdate`.
pub(super) const SCENE_UPDATE: (&str, &[u8]) = ("foxglove.SceneUpdate", include_bytes!("../schemas/SceneUpdate.bin"));
/// Name and descriptor of `foxglove.Log`.
pub(super) const LOG: (&str, &[u8]) = ("foxglove.Log", include_bytes!("../schemas/Log.bin"));

/// The fixed frame.
pub(super) const WORLD: &str = "world";

/// The frame fixed in the body of that name.
pub(super) fn body_frame(body: &str) -> String {
    format!("body/{body}")
}

/// `google.protobuf.Timestamp`.
#[derive(Clone, Copy, PartialEq, Eq, Message)]
pub(super) struct Timestamp {
    #[prost(int64, tag = "1")]
    pub seconds: i64,
    #[prost(int32, tag = "2")]
    pub nanos: i32,
}

#[derive(Clone, Copy, PartialEq, Message)]
pub(super) struct Xyz {
    #[prost(double, tag = "1")]
    pub x: f64,
    #[prost(double, tag = "2")]
    pub y: f64,
    #[prost(double, tag = "3")]
    pub z: f64,
}

#[derive(Clone, Copy, PartialEq, Message)]
pub(super) struct Quaternion {
    #[prost(double, tag = "1")]
    pub x: f64,
    #[prost(double, tag = "2")]
    pub y: f64,
    #[prost(double, tag = "3")]
    pub z: f64,
    #[prost(double, tag = "4")]
    pub w: f64,
}

#[derive(Clone, Copy, PartialEq, Message)]
pub(super) struct Pose {
    #[prost(message, optional, tag = "1")]
    pub position: Option<Xyz>,
    #[prost(message, optional, tag = "2")]
    pub orientation: Option<Quaternion>,
}

#[derive(Clone, Copy, PartialEq, Message)]
pub(super) struct Color {
    #[prost(double, tag = "1")]
    pub r: f64,
    #[prost(double, tag = "2")]
    pub g: f64,
    #[prost(double, tag = "3")]
    pub b: f64,
    #[prost(double, tag = "4")]
    pub a: f64,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct FrameTransform {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    pub parent_frame_id: String,
    #[prost(string, tag = "3")]
    pub child_frame_id: String,
    #[prost(message, optional, tag = "4")]
    pub translation: Option<Xyz>,
    #[prost(message, optional, tag = "5")]
    pub rotation: Option<Quaternion>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct SceneUpdate {
    #[prost(message, repeated, tag = "2")]
    pub entities: Vec<SceneEntity>,
}

/// Without a lifetime: it stays until another of the same `id` replaces it.
#[derive(Clone, PartialEq, Message)]
pub(super) struct SceneEntity {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    pub frame_id: String,
    #[prost(string, tag = "3")]
    pub id: String,
    #[prost(bool, tag = "5")]
    pub frame_locked: bool,
    #[prost(message, repeated, tag = "6")]
    pub metadata: Vec<KeyValuePair>,
    #[prost(message, repeated, tag = "7")]
    pub arrows: Vec<ArrowPrimitive>,
    #[prost(message, repeated, tag = "12")]
    pub triangles: Vec<TriangleListPrimitive>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct KeyValuePair {
    #[prost(string, tag = "1")]
    pub key: String,
    #[prost(string, tag = "2")]
    pub value: String,
}

/// Points along +x of its pose.
#[derive(Clone, Copy, PartialEq, Message)]
pub(super) struct ArrowPrimitive {
    #[prost(message, optional, tag = "1")]
    pub pose: Option<Pose>,
    #[prost(double, tag = "2")]
    pub shaft_length: f64,
    #[prost(double, tag = "3")]
    pub shaft_diameter: f64,
    #[prost(double, tag = "4")]
    pub head_length: f64,
    #[prost(double, tag = "5")]
    pub head_diameter: f64,
    #[prost(message, optional, tag = "6")]
    pub color: Option<Color>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct TriangleListPrimitive {
    #[prost(message, optional, tag = "1")]
    pub pose: Option<Pose>,
    #[prost(message, repeated, tag = "2")]
    pub points: Vec<Xyz>,
    #[prost(message, optional, tag = "3")]
    pub color: Option<Color>,
    #[prost(fixed32, repeated, tag = "5")]
    pub indices: Vec<u32>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct Log {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(int32, tag = "2")]
    pub level: i32,
    #[prost(string, tag = "3")]
    pub message: String,
    #[prost(string, tag = "4")]
    pub name: String,
}

impl Log {
    pub const INFO: i32 = 2;
    pub const WARNING: i32 = 3;
}

impl Timestamp {
    #[expect(clippy::cast_possible_truncation, reason = "below 1e9")]
    pub fn of(stamp_ns: i64) -> Self {
        Self { seconds: stamp_ns.div_euclid(1_000_000_000), nanos: stamp_ns.rem_euclid(1_000_000_000) as i32 }
    }
}

impl From<Vector3<f64>> for Xyz {
    fn from(vector: Vector3<f64>) -> Self {
        Self { x: vector.x, y: vector.y, z: vector.z }
    }
}

impl From<UnitQuaternion<f64>> for Quaternion {
    fn from(rotation: UnitQuaternion<f64>) -> Self {
        Self { x: rotation.i, y: rotation.j, z: rotation.k, w: rotation.w }
    }
}

impl Color {
    /// From 0 to 255 each.
    pub fn of([r, g, b, a]: [u8; 4]) -> Self {
        let [r, g, b, a] = [r, g, b, a].map(|part| f64::from(part) / 255.0);
        Self { r, g, b, a }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::descriptor::FileDescriptorSet;
    use super::*;

    /// Number and type of every field of Foxglove's messages, by message and field.
    fn official() -> BTreeMap<(String, String), (i32, &'static str)> {
        let mut fields = BTreeMap::new();
        for (_, bytes) in [FRAME_TRANSFORMS, SCENE_UPDATE, LOG] {
            let set = FileDescriptorSet::decode(bytes).expect("a descriptor");
            for message in set.file.into_iter().flat_map(|file| file.message_type) {
                for field in message.field {
                    let kind = match field.kind {
                        1 => "double",
                        3 => "int64",
                        5 | 14 => "int32",
                        7 => "fixed32",
                        8 => "bool",
                        9 => "string",
                        11 => "message",
                        _ => "another",
                    };
                    fields.insert((message.name.clone(), field.name), (field.number, kind));
                }
            }
        }
        fields
    }

    /// Every field declared in this file, from its text: message, field, number, type.
    fn declared() -> Vec<(String, String, i32, String)> {
        let (mut fields, mut message, mut tag) = (Vec::new(), String::new(), None);
        for line in include_str!("foxglove.rs").lines().map(str::trim) {
            if let Some(name) = line.strip_prefix("pub(super) struct ") {
                message = name.trim_end_matches(" {").into();
            } else if let Some(rest) = line.strip_prefix("#[prost(") {
                let kind = rest.split(',').next().unwrap_or_default().to_owned();
                let number = rest.split('"').nth(1).and_then(|number| number.parse().ok()).expect("a tag");
                tag = Some((number, kind));
            } else if let (Some(rest), Some((number, kind))) = (line.strip_prefix("pub "), tag.take()) {
                let name = rest.split(':').next().unwrap_or_default().to_owned();
                fields.push((message.clone(), name, number, kind));
            }
        }
        fields
    }

    #[test]
    fn messages_are_foxgloves() {
        let official = official();
        let declared = declared();
        assert_eq!(declared.len(), 44, "one entry a field");
        // Written without a type of its own, by its key.
        let transforms = ("FrameTransforms".to_owned(), "transforms".to_owned());
        assert_eq!(official.get(&transforms), Some(&(1, "message")));
        for (message, field, number, kind) in declared {
            let messages = if message == "Xyz" { vec!["Vector3", "Point3"] } else { vec![message.as_str()] };
            for message in messages {
                let found = official.get(&(message.into(), field.clone()));
                assert_eq!(found, Some(&(number, kind.as_str())), "{message}.{field}");
            }
        }
    }
}
