use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::blueprint::archetypes::{Background, EyeControls3D, LineGrid3D, VisibleTimeRanges};
use re_sdk_types::blueprint::components::{BackgroundKind, ContainerKind, Eye3DKind, VisibleTimeRange};
use re_sdk_types::components::{Color, Plane3D};

use super::blueprint::{Blueprint, Container, Part, View};
use super::columns::{narrow, single};
use super::palette;
use super::poinsot::PoinsotEntities;
use crate::recording::RecordingError;
use crate::recording::picture::{Picture, Poinsot};
use crate::scenario::Plan;

/// How far the camera is, in units of the half height of what must be in the picture: the viewer opens 55° from top to
/// bottom. Of several bodies side by side each has a part of the width, and is looked at from farther away.
fn distance(bodies: usize) -> f64 {
    let bodies = u32::try_from(bodies).unwrap_or(u32::MAX);
    (1.25 * f64::from(bodies)).max(2.5)
}

/// The two views of the construction, each a part with a view for each body that turns freely.
///
/// # Errors
/// If they cannot be written.
pub(super) fn write<W: Write>(
    blueprint: &mut Blueprint<'_, W>,
    plan: &Plan,
    picture: &Picture,
    trace: &VisibleTimeRange,
) -> Result<Vec<Part>, RecordingError> {
    let distance = distance(plan.bodies.len());
    let (mut rolling, mut body_frame) = (Vec::new(), Vec::new());
    for (body, drawing) in plan.bodies.iter().zip(&picture.bodies) {
        let Some(poinsot) = &drawing.poinsot else { continue };
        let owner = if plan.bodies.len() > 1 { format!("{}: ", body.name) } else { String::new() };
        let entities = PoinsotEntities::new(&body.name);
        let all = |origin: &str| [format!("{origin}/**")];
        let view = new_view(blueprint, &format!("{owner}Poinsot"), &entities.rolling, &all(&entities.rolling))?;
        roll(blueprint, &view, (poinsot, distance))?;
        let range = VisibleTimeRanges::new([trace.clone()]);
        blueprint.set(&view.overridden(&entities.herpolhode), &range)?;
        rolling.push(view);
        let name = format!("{owner}L in the body");
        let view = new_view(blueprint, &name, &entities.body_frame, &all(&entities.body_frame))?;
        stand(blueprint, &view, distance * poinsot.axis_length())?;
        body_frame.push(view);
    }
    let mut parts = Vec::new();
    for (name, mut views) in [("Poinsot", rolling), ("L in the body", body_frame)] {
        if views.len() > 1 {
            let row = Container { kind: ContainerKind::Horizontal, name, parts: &views, shares: &[] };
            views = vec![blueprint.container(&row)?];
        }
        parts.append(&mut views);
    }
    Ok(parts)
}

/// Looks at the ellipsoid on the plane, which is below it: the camera's up is against L.
fn roll<W: Write>(
    blueprint: &mut Blueprint<'_, W>,
    view: &Part,
    (poinsot, distance): (&Poinsot, f64),
) -> Result<(), RecordingError> {
    let up = -poinsot.normal;
    let front = Vector3::ith(up.iamin(), 1.0);
    let front = (front - up * front.dot(&up)).try_normalize(0.0).unwrap_or_else(Vector3::x);
    // From the top of a ball about the ellipsoid down to the plane, and to the tip of L below it.
    let target = poinsot.normal * (0.5 * (1.3 * poinsot.distance - 1.0));
    look(blueprint, view, (target + (front * 0.95 + up * 0.3) * distance, target), up)?;
    let [red, green, blue, opacity] = palette::GRID;
    let plane = LineGrid3D::new()
        .with_visible(true)
        .with_plane(Plane3D::new(single(&poinsot.normal), narrow(poinsot.distance)))
        .with_spacing(0.2)
        .with_stroke_width(1.0)
        .with_color(Color::from_unmultiplied_rgba(red, green, blue, opacity));
    blueprint.set(&view.property("LineGrid3D"), &plane)
}

/// Looks at sphere and ellipsoid as the body sees them, at rest.
fn stand<W: Write>(blueprint: &mut Blueprint<'_, W>, view: &Part, distance: f64) -> Result<(), RecordingError> {
    let eye = Vector3::new(0.78, 0.52, 0.36).normalize() * distance;
    look(blueprint, view, (eye, Vector3::zeros()), Vector3::z())?;
    blueprint.set(&view.property("LineGrid3D"), &LineGrid3D::new().with_visible(false))
}

/// A 3D view of `contents`, seen from where `origin` is.
///
/// # Errors
/// If it cannot be written.
pub(super) fn new_view<W: Write>(
    blueprint: &mut Blueprint<'_, W>,
    name: &str,
    origin: &str,
    contents: &[String],
) -> Result<Part, RecordingError> {
    let view = blueprint.view(&View { class: "3D", name, origin, contents })?;
    let [red, green, blue] = palette::BACKGROUND;
    let background = Background::new(BackgroundKind::SolidColor).with_color(Color::from_rgb(red, green, blue));
    blueprint.set(&view.property("Background"), &background)?;
    Ok(view)
}

/// Sets the camera: where it stands and what it looks at, and which way is up.
///
/// # Errors
/// If it cannot be written.
pub(super) fn look<W: Write>(
    blueprint: &mut Blueprint<'_, W>,
    view: &Part,
    (eye, target): (Vector3<f64>, Vector3<f64>),
    up: Vector3<f64>,
) -> Result<(), RecordingError> {
    let eye = EyeControls3D::new()
        .with_kind(Eye3DKind::Orbital)
        .with_position(single(&eye))
        .with_look_target(single(&target))
        .with_eye_up(single(&up));
    blueprint.set(&view.property("EyeControls3D"), &eye)
}
