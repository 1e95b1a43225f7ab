use std::collections::BTreeMap;

use nalgebra::{UnitQuaternion, Vector3};
use prost::Message;

use super::container::{Output, Topic};
use super::foxglove::{
    ArrowPrimitive, Color, FRAME_TRANSFORMS, FrameTransform, FrameTransforms, KeyValuePair, Pose, SCENE_UPDATE,
    SceneEntity, SceneUpdate, Timestamp, WORLD, body_frame,
};
use crate::recording::RecordingError;
use crate::recording::picture::{BodyPicture, Picture, attitude};
use crate::scenario::Plan;
use crate::telemetry::{BodySamples, Channel, Samples};

/// What moves in a 3D view: frames on `/tf`, arrows on `/scene`.
#[derive(Debug)]
pub(super) struct MovingScene {
    frames: Option<Topic>,
    arrows: Option<Topic>,
    bodies: Vec<MovingBody>,
}

#[derive(Debug)]
struct MovingBody {
    name: String,
    picture: BodyPicture,
}

impl MovingScene {
    /// Registers `/tf` and `/scene`, each only if there will be something on it.
    pub fn new(plan: &Plan, picture: &Picture, output: &mut Output) -> Result<Self, RecordingError> {
        let nothing = BTreeMap::new();
        let bodies = || plan.bodies.iter().zip(&picture.bodies);
        let has_frames = plan.bodies.iter().any(|body| body.channels.contains(&Channel::Attitude));
        let has_arrows = picture.bodies.iter().any(|body| !body.arrows.is_empty());
        let frames = if has_frames { Some(output.topic("/tf", FRAME_TRANSFORMS, &nothing)?) } else { None };
        let arrows = if has_arrows { Some(output.topic("/scene", SCENE_UPDATE, &nothing)?) } else { None };
        let bodies = bodies().map(|(body, picture)| MovingBody { name: body.name.clone(), picture: picture.clone() });
        Ok(Self { frames, arrows, bodies: bodies.collect() })
    }

    /// Draws sample `index` of the batch.
    pub fn draw(&mut self, samples: &Samples, index: usize, output: &mut Output) -> Result<(), RecordingError> {
        let stamp = samples.stamps_ns[index];
        let bodies = || self.bodies.iter().zip(&samples.bodies);
        if let Some(topic) = &mut self.frames {
            let transforms = bodies().filter_map(|(body, samples)| body.frame(samples, index, stamp)).collect();
            output.send(topic, stamp, |bytes| FrameTransforms { transforms }.encode_raw(bytes))?;
        }
        if let Some(topic) = &mut self.arrows {
            let entities = bodies().flat_map(|(body, samples)| body.arrows(samples, index, stamp)).collect();
            output.send(topic, stamp, |bytes| SceneUpdate { entities }.encode_raw(bytes))?;
        }
        Ok(())
    }
}

impl MovingBody {
    fn frame(&self, samples: &BodySamples, index: usize, stamp_ns: i64) -> Option<FrameTransform> {
        Some(FrameTransform {
            timestamp: Some(Timestamp::of(stamp_ns)),
            parent_frame_id: WORLD.into(),
            child_frame_id: body_frame(&self.name),
            translation: Some(self.position(samples, index).into()),
            rotation: Some(attitude(samples, index)?.into()),
        })
    }

    fn arrows(&self, samples: &BodySamples, index: usize, stamp_ns: i64) -> impl Iterator<Item = SceneEntity> {
        self.picture.arrows.iter().filter_map(move |arrow| {
            let vector = arrow.quantity.in_world(samples, index)? * arrow.metres_per_unit;
            let shape = self.arrow(vector, self.position(samples, index), arrow.colour);
            let (_, _, name) = arrow.quantity.words();
            Some(SceneEntity {
                timestamp: Some(Timestamp::of(stamp_ns)),
                frame_id: WORLD.into(),
                id: format!("{}/{name}", self.name),
                metadata: vec![KeyValuePair { key: "scale".into(), value: arrow.label.clone() }],
                arrows: shape.into_iter().collect(),
                ..SceneEntity::default()
            })
        })
    }

    /// From `start` along `vector`, in m; none for a vector without direction. Shaft and head share its length.
    fn arrow(&self, vector: Vector3<f64>, start: Vector3<f64>, [red, green, blue]: [u8; 3]) -> Option<ArrowPrimitive> {
        let length = vector.norm();
        if length == 0.0 {
            return None;
        }
        let thickness = 0.03 * self.picture.extent;
        let head_length = (4.0 * thickness).min(0.5 * length);
        Some(ArrowPrimitive {
            pose: Some(Pose { position: Some(start.into()), orientation: Some(along_x(vector / length).into()) }),
            shaft_length: length - head_length,
            shaft_diameter: thickness,
            head_length,
            head_diameter: 2.0 * thickness,
            color: Some(Color::of([red, green, blue, u8::MAX])),
        })
    }

    /// Of the reference point.
    fn position(&self, samples: &BodySamples, index: usize) -> Vector3<f64> {
        match samples.channel(Channel::Position) {
            Some([x, y, z]) => Vector3::new(x[index], y[index], z[index]),
            _ => self.picture.position,
        }
    }
}

/// The turn that brings +x to `direction`: half a turn about +y where that is −x.
fn along_x(direction: Vector3<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::rotation_between(&Vector3::x(), &direction)
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::PI))
}
