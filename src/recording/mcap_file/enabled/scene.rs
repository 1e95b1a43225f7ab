use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::container::{Output, Topic};
use super::foxglove::{
    ArrowPrimitive, Color, FRAME_TRANSFORMS, FrameTransform, KeyValuePair, Pose, Quaternion, SCENE_UPDATE, SceneEntity,
    WORLD, Xyz, body_frame,
};
use super::template::{Stamp, Template, begin};
use crate::recording::RecordingError;
use crate::recording::picture::{Arrow, BodyPicture, Picture, attitude};
use crate::scenario::{Plan, PlannedBody};
use crate::telemetry::{BodySamples, Channel, Samples};

/// Key of a `foxglove.FrameTransform` in `foxglove.FrameTransforms`.
const FRAME_KEY: u8 = 1 << 3 | 2;
/// Key of a `foxglove.SceneEntity` in `foxglove.SceneUpdate`.
const ENTITY_KEY: u8 = 2 << 3 | 2;
/// Key of the time in both: the first field, so that templates follow it.
const TIMESTAMP_KEY: u8 = 1 << 3 | 2;

/// What moves in a 3D view: frames on `/tf`, arrows on `/scene`.
#[derive(Debug)]
pub(super) struct MovingScene {
    frames: Option<Topic>,
    arrows: Option<Topic>,
    bodies: Vec<MovingBody>,
}

#[derive(Debug)]
struct MovingBody {
    /// Of the reference point where it does not move, m.
    position: Vector3<f64>,
    /// Thickness of its arrows, m.
    thickness: f64,
    /// Where the body is and how it is turned.
    frame: Template,
    arrows: Vec<MovingArrow>,
}

#[derive(Debug)]
struct MovingArrow {
    arrow: Arrow,
    /// Where it starts, how it is turned, how long shaft and head are.
    drawn: Template,
    /// Of a vector without direction: the same entity, empty.
    absent: Template,
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
        let bodies = bodies().map(|(body, picture)| MovingBody::new(body, picture)).collect();
        Ok(Self { frames, arrows, bodies })
    }

    /// Draws sample `index` of the batch.
    pub fn draw(&mut self, samples: &Samples, index: usize, output: &mut Output) -> Result<(), RecordingError> {
        let stamp_ns = samples.stamps_ns[index];
        let stamp = Stamp::new(TIMESTAMP_KEY, stamp_ns);
        let bodies = || self.bodies.iter().zip(&samples.bodies);
        if let Some(topic) = &mut self.frames {
            output.send(topic, stamp_ns, |bytes| {
                bodies().for_each(|(body, samples)| body.append_frame(samples, index, &stamp, bytes));
            })?;
        }
        if let Some(topic) = &mut self.arrows {
            output.send(topic, stamp_ns, |bytes| {
                bodies().for_each(|(body, samples)| body.append_arrows(samples, index, &stamp, bytes));
            })?;
        }
        Ok(())
    }
}

impl MovingBody {
    fn new(body: &PlannedBody, picture: &BodyPicture) -> Self {
        let [x, y, z, qx, qy, qz, qw] = [0, 1, 2, 3, 4, 5, 6].map(Template::mark);
        let frame = FrameTransform {
            timestamp: None,
            parent_frame_id: WORLD.into(),
            child_frame_id: body_frame(&body.name),
            translation: Some(Xyz { x, y, z }),
            rotation: Some(Quaternion { x: qx, y: qy, z: qz, w: qw }),
        };
        let thickness = 0.03 * picture.extent;
        let arrows = picture.arrows.iter().map(|arrow| MovingArrow::new(&body.name, arrow, thickness)).collect();
        Self { position: picture.position, thickness, frame: Template::of(&frame, 7), arrows }
    }

    fn append_frame(&self, samples: &BodySamples, index: usize, stamp: &Stamp, bytes: &mut Vec<u8>) {
        let Some(turn) = attitude(samples, index) else { return };
        let [x, y, z] = self.position(samples, index).into();
        begin(FRAME_KEY, stamp.len() + self.frame.len(), bytes);
        bytes.extend_from_slice(stamp.bytes());
        self.frame.append([x, y, z, turn.i, turn.j, turn.k, turn.w], bytes);
    }

    fn append_arrows(&self, samples: &BodySamples, index: usize, stamp: &Stamp, bytes: &mut Vec<u8>) {
        let [x, y, z] = self.position(samples, index).into();
        for MovingArrow { arrow, drawn, absent } in &self.arrows {
            let Some(vector) = arrow.quantity.in_world(samples, index) else { continue };
            let vector = vector * arrow.metres_per_unit;
            let length = vector.norm();
            let template = if length == 0.0 { absent } else { drawn };
            begin(ENTITY_KEY, stamp.len() + template.len(), bytes);
            bytes.extend_from_slice(stamp.bytes());
            // Shaft and head share the vector's length.
            let head = (4.0 * self.thickness).min(0.5 * length);
            let [qx, qy, qz, qw] = along_x(vector / length);
            template.append([x, y, z, qx, qy, qz, qw, length - head, head], bytes);
        }
    }

    /// Of the reference point.
    fn position(&self, samples: &BodySamples, index: usize) -> Vector3<f64> {
        match samples.channel(Channel::Position) {
            Some([x, y, z]) => Vector3::new(x[index], y[index], z[index]),
            _ => self.position,
        }
    }
}

impl MovingArrow {
    fn new(body: &str, arrow: &Arrow, thickness: f64) -> Self {
        let [x, y, z, qx, qy, qz, qw, shaft_length, head_length] = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(Template::mark);
        let [red, green, blue] = arrow.colour;
        let shape = ArrowPrimitive {
            pose: Some(Pose {
                position: Some(Xyz { x, y, z }),
                orientation: Some(Quaternion { x: qx, y: qy, z: qz, w: qw }),
            }),
            shaft_length,
            shaft_diameter: thickness,
            head_length,
            head_diameter: 2.0 * thickness,
            color: Some(Color::of([red, green, blue, u8::MAX])),
        };
        let (_, _, name) = arrow.quantity.words();
        let absent = SceneEntity {
            frame_id: WORLD.into(),
            id: format!("{body}/{name}"),
            metadata: vec![KeyValuePair { key: "scale".into(), value: arrow.label.clone() }],
            ..SceneEntity::default()
        };
        let drawn = SceneEntity { arrows: vec![shape], ..absent.clone() };
        Self { arrow: arrow.clone(), drawn: Template::of(&drawn, 9), absent: Template::of(&absent, 0) }
    }
}

/// The turn that brings +x to the unit vector `direction`: half a turn about +y where that is −x. Sine and cosine of half
/// the angle, each by what does not cancel.
fn along_x(direction: Vector3<f64>) -> [f64; 4] {
    let [x, y, z] = direction.into();
    if x >= 0.0 {
        let cosine = (0.5 * (1.0 + x)).sqrt();
        let share = 0.5 / cosine;
        return [0.0, -z * share, y * share, cosine];
    }
    let (sine, across) = ((0.5 * (1.0 - x)).sqrt(), (y * y + z * z).sqrt());
    if across == 0.0 {
        return [0.0, 1.0, 0.0, 0.0];
    }
    let share = sine / across;
    [0.0, -z * share, y * share, 0.5 * across / sine]
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitQuaternion;

    use super::*;

    /// Each component is rounded four times at most, as is what turning by it makes.
    #[test]
    fn an_arrow_points_along_its_vector() {
        let directions = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [3.0, -4.0, 12.0]];
        let nearly_back = [[-1.0, 1e-9, 0.0], [-1.0, 0.0, -1e-200], [-3.0, 1e-3, 2.0], [-1e-12, 1.0, 1.0]];
        for direction in directions.into_iter().chain(nearly_back) {
            let direction = Vector3::from(direction).normalize();
            let [x, y, z, w] = along_x(direction);
            let turn = nalgebra::Quaternion::new(w, x, y, z);
            assert!((turn.norm() - 1.0).abs() < 5e-16, "{direction}");
            let error = UnitQuaternion::new_unchecked(turn) * Vector3::x() - direction;
            assert!(error.norm() < 1e-15, "{direction}: {error}");
        }
    }
}
