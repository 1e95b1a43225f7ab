use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::blueprint::archetypes::{Background, EyeControls3D, LineGrid3D, VisibleTimeRanges};
use re_sdk_types::blueprint::components::{BackgroundKind, ContainerKind, Eye3DKind, VisibleTimeRange};
use re_sdk_types::components::{Color, Plane3D};
use re_sdk_types::datatypes::{self, TimeInt, TimeRange, TimeRangeBoundary};

use super::blueprint::{Blueprint, Container, Part, View};
use super::columns::{SIM_TIME, narrow, single};
use super::statics::BodyEntities;
use super::stream::{Store, Stream};
use super::trail::Cut;
use super::{palette, points};
use crate::recording::picture::{Picture, scale};
use crate::recording::subject::bodies;
use crate::recording::{RecordingError, Sampling};
use crate::scenario::{EventKind, Plan, nanoseconds};

/// What is on the screen at first: the picture above its explanation, the plots beside them.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    plan: &Plan,
    picture: &Picture,
) -> Result<(), RecordingError> {
    let mut blueprint = Blueprint::new(stream, store);
    let trace = trace_range(Cut::new(plan, picture));
    let mut scene = scene(&mut blueprint, plan, picture, &trace)?;
    let mut words = words(&mut blueprint, plan)?;
    let mut shares = [5.0, 2.0];
    let mut beside = super::near_views::write(&mut blueprint, plan, picture)?;
    let mut construction = super::poinsot_views::write(&mut blueprint, plan, picture, &trace)?;
    let tabs = |parts| Container { kind: ContainerKind::Tabs, name: "", parts, shares: &[] };
    if plan.bodies.len() == 1 {
        beside.append(&mut construction);
    } else if !construction.is_empty() {
        // Each body has a view: they need the room of the scene.
        construction.insert(0, scene);
        scene = blueprint.container(&tabs(&construction))?;
    }
    if !beside.is_empty() {
        let beside = blueprint.container(&tabs(&beside))?;
        let parts = [beside, words];
        let row = Container { kind: ContainerKind::Horizontal, name: "", parts: &parts, shares: &[] };
        words = blueprint.container(&row)?;
        shares = [4.0, 3.0];
    }
    let parts = [scene, words];
    let left = Container { kind: ContainerKind::Vertical, name: "", parts: &parts, shares: &shares };
    let left = blueprint.container(&left)?;
    let right = super::plot_views::write(&mut blueprint, &bodies(plan, &[]), Sampling::of(&plan.grid), Some(picture))?;
    let columns: Vec<_> = [Some(left), right].into_iter().flatten().collect();
    let root = blueprint.container(&Container {
        kind: ContainerKind::Horizontal,
        name: "",
        parts: &columns,
        shares: &[3.0, 2.0][..columns.len()],
    })?;
    blueprint.root(&root, picture.playback_speed)
}

/// The ground that the picture stands on, so that the eye knows up from down.
pub(super) struct Floor {
    /// z, m.
    height: f64,
    /// Between the lines of its grid, m.
    spacing: f64,
    /// Length of the world's axes, m.
    pub(super) axes: f64,
    /// Where the world's axes are drawn: on the left of the bodies, or before the middle of a long row, m.
    pub(super) corner: Vector3<f64>,
}

impl Floor {
    pub(super) fn of(plan: &Plan, picture: &Picture) -> Self {
        let size = picture.size;
        let height = picture.floor;
        let view = picture.target - picture.eye;
        let ahead = Vector3::new(view.x, view.y, 0.0).try_normalize(0.0).unwrap_or_else(Vector3::x);
        let left = Vector3::z().cross(&ahead);
        let distances = picture.bodies.iter().map(|drawing| (drawing.position - picture.target).xy().norm());
        let spread = distances.fold(0.0, f64::max);
        let distance = view.norm();
        let beside = left * (spread + 1.9 * size) + ahead * (0.2 * size);
        // Beside a long row there is no room in the picture, before it there is.
        let is_long = spread > 3.0 * size && plan.bodies.len() > 1;
        let corner = picture.target + if is_long { ahead * (-0.42 * distance) } else { beside };
        Self {
            height,
            spacing: round_number(size.max(0.08 * distance)),
            axes: (0.5 * size).max(0.06 * distance),
            corner: Vector3::new(corner.x, corner.y, height),
        }
    }
}

/// The picture: camera, floor, and how much of the trails is shown.
fn scene<W: Write>(
    blueprint: &mut Blueprint<'_, W>,
    plan: &Plan,
    picture: &Picture,
    trace: &VisibleTimeRange,
) -> Result<Part, RecordingError> {
    let mut contents = vec!["/world/**".to_owned()];
    for (body, drawing) in plan.bodies.iter().zip(&picture.bodies) {
        if drawing.travels {
            // From so far only the body and its way are seen; the view that goes along has the rest.
            let entities = BodyEntities::new(&body.name);
            let points = (!body.points.is_empty()).then(|| format!("- {}/points/**", entities.body));
            contents.extend([entities.axes, entities.vectors].map(|hidden| format!("- {hidden}/**")));
            contents.extend(points);
        }
    }
    let view = blueprint.view(&View { class: "3D", name: &plan.title, origin: "/world", contents: &contents })?;
    let eye = EyeControls3D::new()
        .with_kind(Eye3DKind::Orbital)
        .with_position(single(&picture.eye))
        .with_look_target(single(&picture.target))
        .with_eye_up([0.0_f32, 0.0, 1.0]);
    blueprint.set(&view.property("EyeControls3D"), &eye)?;
    let [red, green, blue] = palette::BACKGROUND;
    let background = Background::new(BackgroundKind::SolidColor).with_color(Color::from_rgb(red, green, blue));
    blueprint.set(&view.property("Background"), &background)?;
    let floor = Floor::of(plan, picture);
    let [red, green, blue, opacity] = palette::GRID;
    let grid = LineGrid3D::new()
        .with_visible(true)
        .with_plane(Plane3D::new([0.0, 0.0, 1.0], narrow(floor.height)))
        .with_spacing(narrow(floor.spacing))
        .with_stroke_width(1.0)
        .with_color(Color::from_unmultiplied_rgba(red, green, blue, opacity));
    blueprint.set(&view.property("LineGrid3D"), &grid)?;
    let range = VisibleTimeRanges::new([trace.clone()]);
    for body in &plan.bodies {
        let entities = BodyEntities::new(&body.name);
        blueprint.set(&view.overridden(&entities.trail), &range)?;
        blueprint.set(&view.overridden(&entities.path), &range)?;
        for point in body.points.iter().filter(|point| points::leaves_path(point)) {
            blueprint.set(&view.overridden(&points::path(point)), &range)?;
        }
    }
    Ok(view)
}

/// From the window's begin to the cursor.
fn trace_range(cut: Cut) -> VisibleTimeRange {
    let start = match cut.window_s {
        Some(window) => TimeRangeBoundary::CursorRelative(TimeInt(-nanoseconds(window))),
        None => TimeRangeBoundary::Infinite,
    };
    let range = TimeRange { start, end: TimeRangeBoundary::CursorRelative(TimeInt(0)) };
    VisibleTimeRange(datatypes::VisibleTimeRange { timeline: SIM_TIME.into(), range })
}

/// The explanation, and the events if there are any: beside it where loads begin and end, else behind it.
fn words<W: Write>(blueprint: &mut Blueprint<'_, W>, plan: &Plan) -> Result<Part, RecordingError> {
    let contents = ["/about".to_owned()];
    let about = View { class: "TextDocument", name: "What this is", origin: "/about", contents: &contents };
    let about = blueprint.view(&about)?;
    if plan.events.is_empty() {
        return Ok(about);
    }
    let contents = ["/log".to_owned()];
    let log = blueprint.view(&View { class: "TextLog", name: "Events", origin: "/log", contents: &contents })?;
    let parts = [about, log];
    if plan.events.iter().any(|event| event.kind == EventKind::Load) {
        let shares = &[3.0, 2.0];
        return blueprint.container(&Container { kind: ContainerKind::Horizontal, name: "", parts: &parts, shares });
    }
    blueprint.container(&Container { kind: ContainerKind::Tabs, name: "", parts: &parts, shares: &[] })
}

/// The nearest of 1, 2, 5 × 10ⁿ below.
fn round_number(value: f64) -> f64 {
    if !value.is_normal() {
        return 1.0;
    }
    scale::round_down(value)
}
