use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::blueprint::archetypes::{Background, EyeControls3D, LineGrid3D, PlotLegend};
use re_sdk_types::blueprint::components::{BackgroundKind, ContainerKind, Corner2D, Eye3DKind};
use re_sdk_types::components::{Color, Plane3D};

use super::blueprint::{Blueprint, Container, Part, View};
use super::columns::{narrow, single};
use super::overlay::{curve_entities, extent};
use super::palette;
use super::plot_views::whole_run;
use super::stream::{Store, Stream};
use crate::recording::overlay::Overlay;
use crate::recording::picture::camera::{self, Room};
use crate::recording::picture::{pace, scale};
use crate::recording::{RecordingError, Sampling};

/// Plots on the screen at once; the rest are tabs of the last.
const VISIBLE: usize = 4;

/// Where bodies stand whose position is not known, and from where all are seen.
pub(super) struct Scenery {
    /// Of each body, m.
    pub places: Vec<Vector3<f64>>,
    eye: Vector3<f64>,
    target: Vector3<f64>,
    floor: f64,
    size: f64,
}

impl Scenery {
    pub fn of(overlay: &Overlay) -> Self {
        let size = overlay.bodies.iter().map(extent).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
        let mut places = Vec::new();
        let mut rooms = Vec::new();
        for (number, body) in (0_u32..).zip(&overlay.bodies) {
            let place = Vector3::new(0.0, 3.0 * size * f64::from(number), 0.0);
            places.push(place);
            let poses = body.poses.rows().iter().flat_map(|(_, poses)| poses);
            let positions = poses.map(|pose| pose.position.map_or(place, Vector3::from));
            let room = |position| Room { lowest: position, highest: position, radius: 1.2 * extent(body) };
            rooms.extend(positions.map(room).reduce(|one, other| Room {
                lowest: one.lowest.inf(&other.lowest),
                highest: one.highest.sup(&other.highest),
                radius: one.radius,
            }));
        }
        let (eye, target) = camera::place(&rooms, &Vector3::zeros());
        // What is looked at from nowhere is not seen.
        let eye = if eye == target { target + Vector3::new(3.0, -2.0, 1.5) } else { eye };
        let floor = rooms.iter().map(|room| room.lowest.z - room.radius).reduce(f64::min).unwrap_or(-1.0);
        Self { places, eye, target, floor, size }
    }
}

/// Both motions in one picture above the words, beside them how far they are apart.
pub(super) fn write<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    overlay: &Overlay,
    scenery: &Scenery,
) -> Result<(), RecordingError> {
    let mut blueprint = Blueprint::new(stream, store);
    let contents = ["/about".to_owned()];
    let about = View { class: "TextDocument", name: "What was found", origin: "/about", contents: &contents };
    let about = blueprint.view(&about)?;
    let is_drawn = overlay.bodies.iter().any(|body| !body.poses.rows().is_empty());
    let left = if is_drawn {
        let parts = [scene(&mut blueprint, scenery)?, about];
        let shares = &[5.0, 3.0];
        blueprint.container(&Container { kind: ContainerKind::Vertical, name: "", parts: &parts, shares })?
    } else {
        about
    };
    let columns: Vec<_> = [Some(left), plots(&mut blueprint, overlay)?].into_iter().flatten().collect();
    let shares = &[3.0, 2.0][..columns.len()];
    let root = Container { kind: ContainerKind::Horizontal, name: "", parts: &columns, shares };
    let root = blueprint.container(&root)?;
    blueprint.root(&root, pace::playback_speed(overlay.to_s - overlay.from_s))
}

fn scene<W: Write>(blueprint: &mut Blueprint<'_, W>, scenery: &Scenery) -> Result<Part, RecordingError> {
    let contents = ["/world/**".to_owned()];
    let view = View { class: "3D", name: "A solid, B translucent", origin: "/world", contents: &contents };
    let view = blueprint.view(&view)?;
    let eye = EyeControls3D::new()
        .with_kind(Eye3DKind::Orbital)
        .with_position(single(&scenery.eye))
        .with_look_target(single(&scenery.target))
        .with_eye_up([0.0_f32, 0.0, 1.0]);
    blueprint.set(&view.property("EyeControls3D"), &eye)?;
    let [red, green, blue] = palette::BACKGROUND;
    let background = Background::new(BackgroundKind::SolidColor).with_color(Color::from_rgb(red, green, blue));
    blueprint.set(&view.property("Background"), &background)?;
    let [red, green, blue, opacity] = palette::GRID;
    let grid = LineGrid3D::new()
        .with_visible(true)
        .with_plane(Plane3D::new([0.0, 0.0, 1.0], narrow(scenery.floor)))
        .with_spacing(narrow(scale::round_down(scenery.size)))
        .with_stroke_width(1.0)
        .with_color(Color::from_unmultiplied_rgba(red, green, blue, opacity));
    blueprint.set(&view.property("LineGrid3D"), &grid)?;
    Ok(view)
}

/// How far each channel is apart, in powers of ten.
fn plots<W: Write>(blueprint: &mut Blueprint<'_, W>, overlay: &Overlay) -> Result<Option<Part>, RecordingError> {
    let sampling = Sampling { samples: 0, from_s: overlay.from_s, to_s: overlay.to_s, interval_s: None };
    let times = whole_run(sampling);
    let mut parts = Vec::new();
    for curve in &overlay.differences {
        let name = format!("{} of {}, log₁₀ of the difference in {}", curve.channel, curve.body, curve.unit);
        let contents = curve_entities(curve);
        let view = View { class: "TimeSeries", name: &name, origin: "/", contents: &contents };
        let part = blueprint.view(&view)?;
        let legend = PlotLegend::new().with_corner(Corner2D::RightTop);
        blueprint.set(&part.property("PlotLegend"), &legend)?;
        blueprint.set(&part.property("TimeAxis"), &times)?;
        parts.push(part);
    }
    if parts.len() > VISIBLE {
        let rest = parts.split_off(VISIBLE - 1);
        let tabs = Container { kind: ContainerKind::Tabs, name: "", parts: &rest, shares: &[] };
        parts.push(blueprint.container(&tabs)?);
    }
    if parts.len() <= 1 {
        return Ok(parts.pop());
    }
    let column = Container { kind: ContainerKind::Vertical, name: "", parts: &parts, shares: &[] };
    blueprint.container(&column).map(Some)
}
