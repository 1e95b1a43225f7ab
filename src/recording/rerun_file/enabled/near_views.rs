use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::blueprint::archetypes::LineGrid3D;

use super::blueprint::{Blueprint, Part};
use super::poinsot_views::{look, new_view};
use super::statics::BodyEntities;
use crate::recording::RecordingError;
use crate::recording::picture::Picture;
use crate::scenario::Plan;

/// How far the camera is from the body, in its extents.
const DISTANCE: f64 = 4.6;

/// For bodies that travel far a view that goes along with the reference point and does not turn; none for others.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write<W: Write>(
    blueprint: &mut Blueprint<'_, W>,
    plan: &Plan,
    picture: &Picture,
) -> Result<Vec<Part>, RecordingError> {
    let direction = (picture.eye - picture.target).try_normalize(0.0).unwrap_or_else(Vector3::x);
    let mut views = Vec::new();
    for (body, drawing) in plan.bodies.iter().zip(&picture.bodies).filter(|(_, drawing)| drawing.travels) {
        let owner = if plan.bodies.len() > 1 { format!("{}: ", body.name) } else { String::new() };
        let entities = BodyEntities::new(&body.name);
        let mut seen = vec![&entities.body, &entities.vectors];
        if !drawing.cords.is_empty() {
            seen.push(&entities.cords);
        }
        let contents: Vec<_> = seen.iter().map(|seen| format!("{seen}/**")).collect();
        let view = new_view(blueprint, &format!("{owner}going along"), &entities.along, &contents)?;
        let eye = direction * (DISTANCE * drawing.extent);
        look(blueprint, &view, (eye, Vector3::zeros()), Vector3::z())?;
        blueprint.set(&view.property("LineGrid3D"), &LineGrid3D::new().with_visible(false))?;
        views.push(view);
    }
    Ok(views)
}
