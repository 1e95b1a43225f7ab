use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::archetypes::{Arrows3D, LineStrips3D, Mesh3D, Points3D, RecordingInfo, ViewCoordinates};
use re_sdk_types::components::Radius;
use re_sdk_types::datatypes::Rgba32;

use super::columns::{narrow, single};
use super::layout::Floor;
use super::palette;
use super::poinsot::PoinsotEntities;
use super::stream::{Store, Stream};
use crate::recording::RecordingError;
use crate::recording::picture::{Arrow, BodyPicture, Picture, Quantity};
use crate::scenario::{Plan, PlannedBody};
use crate::telemetry::Channel;

/// How far the body's axes and the trail's point are from the reference point, in units of the body's extent.
pub(super) const TIP: f64 = 1.3;

/// Where an arrow's label is, in units of its length.
pub(super) const LABEL: f64 = 1.08;

/// Radius of a vector's arrow, in units of the largest body's extent.
const ARROW: f64 = 0.02;

/// How much thicker ω is than the other vectors: where L lies along it, it shows as a sheath.
const SHEATH: f64 = 1.5;

/// Radius of an axis' arrow, in units of the body's extent.
const AXIS: f64 = 0.011;

/// Where a body's parts are logged. All bodies have a folder of their own: no body's name can meet another entity's.
pub(super) struct BodyEntities {
    /// Attitude and position; its children turn with it.
    pub(super) body: String,
    /// Its axes.
    pub(super) axes: String,
    /// Moves with the reference point and does not turn.
    pub(super) along: String,
    /// All vectors.
    pub(super) vectors: String,
    /// Of the spin axis' tip.
    pub(super) trail: String,
    /// Of the reference point.
    pub(super) path: String,
    /// The springs that hold it.
    pub(super) cords: String,
}

impl BodyEntities {
    pub(super) fn new(name: &str) -> Self {
        Self {
            body: format!("/world/body/{name}"),
            axes: format!("/world/body/{name}/axes"),
            along: format!("/world/along/{name}"),
            vectors: format!("/world/vectors/{name}"),
            trail: format!("/world/trail/{name}"),
            path: format!("/world/path/{name}"),
            cords: format!("/world/cords/{name}"),
        }
    }

    /// Of a vector, in world axes.
    pub(super) fn arrow(&self, quantity: Quantity) -> String {
        let (_, _, word) = quantity.words();
        format!("{}/{word}", self.vectors)
    }
}

/// Logs everything in the picture that does not move, and of what moves all that does not change.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    plan: &Plan,
    picture: &Picture,
) -> Result<(), RecordingError> {
    stream.once(store, "/__properties", &[], &RecordingInfo::new().with_name(plan.title.as_str()))?;
    stream.once(store, "/world", &[], &ViewCoordinates::RIGHT_HAND_Z_UP())?;
    let floor = Floor::of(plan, picture);
    let (length, radius) = (floor.axes, floor.axes * 2.0 * AXIS);
    let world = Axes { origin: floor.corner, length, radius, colours: [palette::WORLD; 3] };
    world.write(stream, store, "/world/axes")?;
    world.write_names(stream, store, "/world/axes")?;
    if plan.bodies.len() > 1 {
        stream.once(store, "/world/names", &[], &names(plan, picture))?;
    }
    for (body, drawing) in plan.bodies.iter().zip(&picture.bodies) {
        let entities = BodyEntities::new(&body.name);
        if body.channels.contains(&Channel::Attitude) {
            let distance = (picture.eye - picture.target).norm();
            write_body(stream, store, (body, drawing), (&entities, distance, picture.size))?;
            // Of several bodies, the colours say which axis is which.
            if plan.bodies.len() == 1 {
                body_axes(drawing).write_names(stream, store, &entities.axes)?;
            }
        }
        if let Some(poinsot) = &drawing.poinsot {
            super::poinsot::write(stream, store, poinsot, &PoinsotEntities::new(&body.name))?;
        }
        for arrow in &drawing.arrows {
            let entity = entities.arrow(arrow.quantity);
            // Scales would cover each other where arrows are near; they stand in the text.
            let (symbol, ..) = arrow.quantity.words();
            stream.once(store, &entity, &[], &arrow_style(arrow, picture.size))?;
            stream.once(store, &entity, &[], &label_style([symbol], [arrow.colour]))?;
        }
    }
    Ok(())
}

fn write_body<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    (body, drawing): (&PlannedBody, &BodyPicture),
    (entities, distance, size): (&BodyEntities, f64, f64),
) -> Result<(), RecordingError> {
    for (number, surface) in body.surfaces.iter().enumerate() {
        let mesh = Mesh3D::new(surface.vertices.iter().copied())
            .with_vertex_normals(surface.normals.iter().copied())
            .with_triangle_indices(surface.triangles.iter().copied())
            .with_albedo_factor(rgba(drawing.colour));
        stream.once(store, &format!("{}/shape/{number}", entities.body), &[], &mesh)?;
    }
    body_axes(drawing).write(stream, store, &entities.axes)?;
    // No thinner than a camera so far away can see.
    let width = (drawing.extent * 0.006).max(distance * 0.0012);
    stream.once(store, &entities.trail, &[], &line_style(palette::TRAIL, width))?;
    stream.once(store, &entities.path, &[], &line_style(palette::PATH, width))?;
    if !drawing.cords.is_empty() {
        stream.once(store, &entities.cords, &[], &line_style(palette::CORD, 2.0 * width))?;
    }
    super::points::write(stream, store, body, (size, width))
}

/// The names of the bodies that stay where they are, below them.
fn names(plan: &Plan, picture: &Picture) -> Points3D {
    let bodies = plan.bodies.iter().zip(&picture.bodies);
    let staying = bodies.filter(|(body, _)| !body.channels.contains(&Channel::Position));
    let (names, places): (Vec<_>, Vec<_>) = staying
        .map(|(body, drawing)| {
            (body.name.as_str(), single(&(drawing.position - Vector3::z() * (1.4 * drawing.extent))))
        })
        .unzip();
    Points3D::new(places)
        .with_radii([Radius::new_ui_points(0.0)])
        .with_colors([palette::opaque(palette::NAMES)])
        .with_labels(names)
        .with_show_labels(true)
}

/// The body's, in the colours of its curves.
fn body_axes(drawing: &BodyPicture) -> Axes {
    Axes {
        origin: Vector3::zeros(),
        length: drawing.extent * TIP,
        radius: drawing.extent * AXIS,
        colours: [palette::X, palette::Y, palette::Z],
    }
}

/// Three arrows along x, y, z, and their names at their tips.
struct Axes {
    origin: Vector3<f64>,
    length: f64,
    radius: f64,
    colours: [[u8; 3]; 3],
}

impl Axes {
    fn write<W: Write>(&self, stream: &mut Stream<W>, store: Store, entity: &str) -> Result<(), RecordingError> {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let arrows = Arrows3D::from_vectors(axes.map(|axis| single(&(axis * self.length))))
            .with_origins([single(&self.origin); 3])
            .with_radii([scene(self.radius)])
            .with_colors(self.colours.map(palette::opaque));
        stream.once(store, entity, &[], &arrows)
    }

    fn write_names<W: Write>(&self, stream: &mut Stream<W>, store: Store, entity: &str) -> Result<(), RecordingError> {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let tips = axes.map(|axis| single(&(self.origin + axis * (self.length * LABEL))));
        stream.once(store, entity, &[], &label_style(["x", "y", "z"], self.colours).with_positions(tips))
    }
}

fn arrow_style(arrow: &Arrow, size: f64) -> Arrows3D {
    let thicker = if arrow.quantity == Quantity::AngularVelocity { SHEATH } else { 1.0 };
    Arrows3D::update_fields().with_radii([scene(size * ARROW * thicker)]).with_colors([palette::opaque(arrow.colour)])
}

/// Points too small to see, with words at them. An arrow's own label is at its middle, inside the body.
fn label_style<const N: usize>(labels: [&str; N], colours: [[u8; 3]; N]) -> Points3D {
    Points3D::update_fields()
        .with_radii([Radius::new_ui_points(0.0)])
        .with_colors(colours.map(|colour| palette::opaque(lighter(colour))))
        .with_labels(labels)
        .with_show_labels(true)
}

pub(super) fn line_style(colour: [u8; 3], radius: f64) -> LineStrips3D {
    LineStrips3D::update_fields().with_colors([palette::opaque(colour)]).with_radii([scene(radius)])
}

/// In metres, as far as the viewer can: it packs radii into half precision. Larger ones are in points of the screen.
fn scene(radius: f64) -> Radius {
    const LARGEST: f64 = 60_000.0;
    if radius < LARGEST { Radius::new_scene_units(narrow(radius)) } else { Radius::new_ui_points(1.5) }
}

/// Half way to white: a colour that shows as an arrow is too dark for words.
fn lighter(colour: [u8; 3]) -> [u8; 3] {
    colour.map(|part| part / 2 + 127)
}

fn rgba([red, green, blue, opacity]: [u8; 4]) -> Rgba32 {
    Rgba32::from_unmultiplied_rgba(red, green, blue, opacity)
}
