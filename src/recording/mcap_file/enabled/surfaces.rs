use super::foxglove::{
    Color, Pose, Quaternion, SceneEntity, SceneUpdate, Timestamp, TriangleListPrimitive, Xyz, body_frame,
};
use crate::body::Surface;
use crate::recording::picture::Picture;
use crate::scenario::{Plan, PlannedBody};
use crate::telemetry::Channel;

/// All surfaces of the bodies whose attitude is recorded, each body one entity fixed in its frame; `None` if there is
/// nothing to draw.
pub(super) fn surfaces(plan: &Plan, picture: &Picture, stamp_ns: i64) -> Option<SceneUpdate> {
    let drawn = |body: &PlannedBody| body.channels.contains(&Channel::Attitude) && !body.surfaces.is_empty();
    let bodies = plan.bodies.iter().zip(&picture.bodies).filter(|(body, _)| drawn(body));
    let entities: Vec<_> = bodies
        .map(|(body, picture)| SceneEntity {
            timestamp: Some(Timestamp::of(stamp_ns)),
            frame_id: body_frame(&body.name),
            id: body.name.clone(),
            frame_locked: true,
            triangles: body.surfaces.iter().map(|surface| triangles(surface, Color::of(picture.colour))).collect(),
            ..SceneEntity::default()
        })
        .collect();
    (!entities.is_empty()).then_some(SceneUpdate { entities })
}

/// Viewers compute the normals themselves.
fn triangles(surface: &Surface, colour: Color) -> TriangleListPrimitive {
    let point = |[x, y, z]: [f32; 3]| Xyz { x: x.into(), y: y.into(), z: z.into() };
    TriangleListPrimitive {
        pose: Some(Pose {
            position: Some(Xyz::default()),
            orientation: Some(Quaternion { w: 1.0, ..Quaternion::default() }),
        }),
        points: surface.vertices.iter().copied().map(point).collect(),
        color: Some(colour),
        indices: surface.triangles.concat(),
    }
}
