use std::io::Write;

use nalgebra::{UnitQuaternion, Vector3};
use re_sdk_types::archetypes::{Arrows3D, Ellipsoids3D, LineStrips3D, Points3D};
use re_sdk_types::components::{FillMode, Radius};

use super::columns::{narrow, quaternion, single};
use super::palette;
use super::stream::{Store, Stream};
use crate::recording::RecordingError;
use crate::recording::picture::Poinsot;

/// Radius of curves.
const LINE: f64 = 0.008;

/// Radius of arrows.
const ARROW: f64 = 0.014;

/// Radius of points.
const POINT: f64 = 0.035;

/// Where the parts of the construction are logged.
pub(super) struct PoinsotEntities {
    /// What stands in the world or rolls there.
    pub(super) rolling: String,
    /// The ellipsoid, which turns as the body does.
    pub(super) ellipsoid: String,
    /// ω, whose tip is the point of contact.
    pub(super) contact: String,
    /// The trace of ω in the plane.
    pub(super) herpolhode: String,
    /// What the body sees.
    pub(super) body_frame: String,
    /// L as the body sees it.
    pub(super) momentum: String,
}

impl PoinsotEntities {
    pub(super) fn new(name: &str) -> Self {
        let (rolling, body_frame) = (format!("/poinsot/{name}"), format!("/body_frame/{name}"));
        Self {
            ellipsoid: format!("{rolling}/energy_ellipsoid"),
            contact: format!("{rolling}/angular_velocity"),
            herpolhode: format!("{rolling}/herpolhode"),
            momentum: format!("{body_frame}/angular_momentum"),
            rolling,
            body_frame,
        }
    }
}

/// Logs all of the construction that does not move, and of what moves all that does not change.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    poinsot: &Poinsot,
    entities: &PoinsotEntities,
) -> Result<(), RecordingError> {
    let PoinsotEntities { rolling, ellipsoid, contact, herpolhode, body_frame, momentum } = entities;
    let turn = &poinsot.body_from_principal;
    stream.once(store, ellipsoid, &[], &surface(&poinsot.semi_axes, turn, palette::ENERGY))?;
    if !poinsot.polhode.is_empty() {
        stream.once(store, &format!("{ellipsoid}/polhode"), &[], &curve(&poinsot.polhode))?;
    }
    let tip = poinsot.normal * (1.4 * poinsot.distance);
    let normal = format!("{rolling}/angular_momentum");
    stream.once(store, &normal, &[], &arrow(palette::MOMENTUM).with_vectors([single(&tip)]))?;
    let name = Points3D::new([single(&tip)]).with_radii([Radius::new_ui_points(0.0)]);
    let name = name.with_colors([palette::opaque(palette::MOMENTUM)]).with_labels(["L"]).with_show_labels(true);
    stream.once(store, &normal, &[], &name)?;
    stream.once(store, contact, &[], &arrow(palette::RATE).with_labels(["ω"]).with_show_labels(true))?;
    stream.once(store, contact, &[], &point(palette::RATE))?;
    stream.once(store, herpolhode, &[], &line(palette::TRAIL))?;

    let sphere = surface(&Vector3::repeat(1.0), &UnitQuaternion::identity(), palette::SPHERE);
    stream.once(store, &format!("{body_frame}/momentum_sphere"), &[], &sphere)?;
    let energy = surface(&poinsot.momentum_semi_axes, turn, palette::ENERGY);
    stream.once(store, &format!("{body_frame}/energy_ellipsoid"), &[], &energy)?;
    if !poinsot.momentum_polhode.is_empty() {
        stream.once(store, &format!("{body_frame}/polhode"), &[], &curve(&poinsot.momentum_polhode))?;
    }
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| single(&(axis * poinsot.axis_length())));
    let colours = [palette::X, palette::Y, palette::Z].map(palette::opaque);
    let arrows = Arrows3D::from_vectors(axes).with_radii([length(0.6 * ARROW)]).with_colors(colours);
    stream.once(store, &format!("{body_frame}/axes"), &[], &arrows)?;
    let names = Points3D::new(axes).with_radii([Radius::new_ui_points(0.0)]).with_colors(colours);
    let names = names.with_labels(["x", "y", "z"]).with_show_labels(true);
    stream.once(store, &format!("{body_frame}/axes"), &[], &names)?;
    stream.once(store, momentum, &[], &arrow(palette::MOMENTUM).with_labels(["L"]).with_show_labels(true))?;
    stream.once(store, momentum, &[], &point(palette::MOMENTUM))
}

/// An ellipsoid that one sees through.
fn surface(semi_axes: &Vector3<f64>, turn: &UnitQuaternion<f64>, colour: [u8; 3]) -> Ellipsoids3D {
    Ellipsoids3D::from_half_sizes([single(semi_axes)])
        .with_quaternions([quaternion(*turn).0])
        .with_colors([palette::opaque(colour)])
        .with_line_radii([length(0.4 * LINE)])
        .with_fill_mode(FillMode::TransparentFillMajorWireframe)
}

fn curve(points: &[Vector3<f64>]) -> LineStrips3D {
    line(palette::POLHODE).with_strips([points.iter().map(single).collect::<Vec<_>>()])
}

fn line(colour: [u8; 3]) -> LineStrips3D {
    LineStrips3D::update_fields().with_colors([palette::opaque(colour)]).with_radii([length(LINE)])
}

/// From the centre.
fn arrow(colour: [u8; 3]) -> Arrows3D {
    Arrows3D::update_fields()
        .with_origins([[0.0; 3]])
        .with_radii([length(ARROW)])
        .with_colors([palette::opaque(colour)])
}

fn point(colour: [u8; 3]) -> Points3D {
    Points3D::update_fields().with_radii([length(POINT)]).with_colors([palette::opaque(colour)])
}

fn length(radius: f64) -> Radius {
    Radius::new_scene_units(narrow(radius))
}
