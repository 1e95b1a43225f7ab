//! The same messages as JSON: keys as the schemas name them, times as `sec` and `nsec`.

use serde_json::Value;

use super::super::foxglove::{FrameTransform, Pose, Quaternion, Timestamp, Xyz};
use super::foxglove::{FrameTransforms, Odometry, PoseInFrame, PosesInFrame};

/// A message that JSON can hold. `None` if a key is missing or of another kind.
pub(super) trait FromJson: Sized {
    fn from_json(value: &Value) -> Option<Self>;
}

impl FromJson for FrameTransforms {
    fn from_json(value: &Value) -> Option<Self> {
        Some(Self { transforms: list(value.get("transforms")?)? })
    }
}

impl FromJson for FrameTransform {
    fn from_json(value: &Value) -> Option<Self> {
        Some(Self {
            timestamp: optional(value, "timestamp")?,
            parent_frame_id: text(value, "parent_frame_id")?,
            child_frame_id: text(value, "child_frame_id")?,
            translation: optional(value, "translation")?,
            rotation: optional(value, "rotation")?,
        })
    }
}

impl FromJson for PoseInFrame {
    fn from_json(value: &Value) -> Option<Self> {
        Some(Self {
            timestamp: optional(value, "timestamp")?,
            frame_id: text(value, "frame_id")?,
            pose: optional(value, "pose")?,
        })
    }
}

impl FromJson for PosesInFrame {
    fn from_json(value: &Value) -> Option<Self> {
        Some(Self {
            timestamp: optional(value, "timestamp")?,
            frame_id: text(value, "frame_id")?,
            poses: list(value.get("poses")?)?,
        })
    }
}

impl FromJson for Odometry {
    fn from_json(value: &Value) -> Option<Self> {
        Some(Self {
            timestamp: optional(value, "timestamp")?,
            frame_id: text(value, "frame_id")?,
            body_frame_id: text(value, "body_frame_id")?,
            pose: optional(value, "pose")?,
            linear_velocity: optional(value, "linear_velocity")?,
            angular_velocity: optional(value, "angular_velocity")?,
        })
    }
}

impl FromJson for Pose {
    fn from_json(value: &Value) -> Option<Self> {
        Some(Self { position: optional(value, "position")?, orientation: optional(value, "orientation")? })
    }
}

impl FromJson for Timestamp {
    fn from_json(value: &Value) -> Option<Self> {
        let nanos = i32::try_from(value.get("nsec")?.as_i64()?).ok()?;
        Some(Self { seconds: value.get("sec")?.as_i64()?, nanos })
    }
}

impl FromJson for Quaternion {
    fn from_json(value: &Value) -> Option<Self> {
        let [x, y, z, w] = numbers(value, ["x", "y", "z", "w"])?;
        Some(Self { x, y, z, w })
    }
}

impl FromJson for Xyz {
    fn from_json(value: &Value) -> Option<Self> {
        let [x, y, z] = numbers(value, ["x", "y", "z"])?;
        Some(Self { x, y, z })
    }
}

/// What stands under a key, which may be missing.
#[expect(clippy::option_option, reason = "missing is not malformed")]
fn optional<T: FromJson>(value: &Value, key: &str) -> Option<Option<T>> {
    match value.get(key) {
        None | Some(Value::Null) => Some(None),
        Some(value) => T::from_json(value).map(Some),
    }
}

fn list<T: FromJson>(value: &Value) -> Option<Vec<T>> {
    value.as_array()?.iter().map(T::from_json).collect()
}

fn text(value: &Value, key: &str) -> Option<String> {
    value.get(key)?.as_str().map(str::to_owned)
}

fn numbers<const N: usize>(value: &Value, keys: [&str; N]) -> Option<[f64; N]> {
    let mut numbers = [0.0; N];
    for (number, key) in numbers.iter_mut().zip(keys) {
        *number = value.get(key)?.as_f64()?;
    }
    Some(numbers)
}
