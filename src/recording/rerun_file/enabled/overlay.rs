use std::io::Write;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use re_log_types::{ApplicationId, RecordingId, StoreId, StoreKind};
use re_sdk_types::archetypes::{
    Arrows3D, Mesh3D, RecordingInfo, SeriesLines, TextDocument, Transform3D, ViewCoordinates,
};
use re_sdk_types::components::{Color, MediaType, Radius};
use re_sdk_types::datatypes::Rgba32;
use sha2::{Digest as _, Sha256};

use super::columns::{narrow, quaternion, scalars, sim_time, single};
use super::overlay_layout::{self, Scenery};
use super::stream::{Rows, Store, Stream};
use crate::recording::overlay::{DifferenceCurve, OverlaidBody, Overlay, Pose};
use crate::recording::{PartFile, RecordingError};
use crate::scenario::nanoseconds;

/// Of the first motion: red, green, blue, opacity.
const FIRST: [u8; 4] = [86, 180, 233, 255];
/// Of the second, through which the first is seen.
const SECOND: [u8; 4] = [230, 130, 20, 120];
/// The second is a little larger: surfaces in one place flicker.
const LARGER: f32 = 1.02;

/// Writes what two motions look like over each other.
///
/// # Errors
/// If it cannot be written.
pub fn write_overlay(overlay: &Overlay, file: PartFile) -> Result<PartFile, RecordingError> {
    let path = file.path().to_path_buf();
    let mut stream = Stream::begin(file, path)?;
    let name = format!("polhode-compare-{}", &hash(overlay)[..12]);
    let application = ApplicationId::try_new(name).map_err(|error| stream.refused(error))?;
    let id = |kind, word: &str| {
        StoreId::new(kind, application.clone(), RecordingId::from(format!("{word}{}", hash(overlay))))
    };
    let store = stream.open(id(StoreKind::Recording, ""))?;
    let blueprint = stream.open(id(StoreKind::Blueprint, "layout-"))?;
    let scenery = Scenery::of(overlay);
    overlay_layout::write(&mut stream, blueprint, overlay, &scenery)?;
    stream.activate(blueprint)?;
    stream.once(store, "/__properties", &[], &RecordingInfo::new().with_name(overlay.title.as_str()))?;
    stream.once(store, "/world", &[], &ViewCoordinates::RIGHT_HAND_Z_UP())?;
    let words = TextDocument::new(overlay.words.as_str()).with_media_type(MediaType::markdown());
    stream.once(store, "/about", &[], &words)?;
    for (number, body) in overlay.bodies.iter().enumerate() {
        for side in 0..2 {
            write_body(&mut stream, store, body, side, scenery.places[number])?;
        }
    }
    for curve in &overlay.differences {
        write_curve(&mut stream, store, curve)?;
    }
    stream.end()
}

/// The viewer merges stores of equal ids: equal ids mean equal contents.
fn hash(overlay: &Overlay) -> String {
    let mut hash = Sha256::new();
    let words = overlay.bodies.iter().map(|body| body.name.as_str());
    let curves = overlay.differences.iter().flat_map(|curve| [curve.body.as_str(), curve.channel.as_str()]);
    for part in [env!("CARGO_PKG_VERSION"), &overlay.title, &overlay.words].into_iter().chain(words).chain(curves) {
        hash.update(part.as_bytes());
        hash.update([0]);
    }
    let vertices = overlay.bodies.iter().flat_map(|body| &body.surfaces).flat_map(|surface| &surface.vertices);
    vertices.flatten().for_each(|number| hash.update(number.to_le_bytes()));
    for (time_s, poses) in overlay.bodies.iter().flat_map(|body| body.poses.rows()) {
        hash.update(time_s.to_le_bytes());
        let numbers = poses.iter().flat_map(|pose| pose.attitude.iter().chain(pose.position.iter().flatten()));
        numbers.for_each(|number| hash.update(number.to_le_bytes()));
    }
    for (time_s, difference) in overlay.differences.iter().flat_map(|curve| &curve.points) {
        hash.update(time_s.to_le_bytes());
        hash.update(difference.to_le_bytes());
    }
    format!("{:x}", hash.finalize())[..32].to_owned()
}

/// Where a body of one motion is drawn.
fn body_entity(body: &OverlaidBody, side: usize) -> String {
    format!("/world/{}/{}", ["a", "b"][side], fit(&body.name))
}

/// Where the difference of a channel is plotted, and its limit.
pub(super) fn curve_entities(curve: &DifferenceCurve) -> [String; 2] {
    ["difference", "limit"].map(|word| format!("/{word}/{}/{}", fit(&curve.body), fit(&curve.channel)))
}

/// As an entity's name may be.
fn fit(name: &str) -> String {
    let letter = |letter: char| if letter.is_ascii_alphanumeric() || "_-".contains(letter) { letter } else { '_' };
    name.chars().map(letter).collect()
}

fn write_body<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    body: &OverlaidBody,
    side: usize,
    place: Vector3<f64>,
) -> Result<(), RecordingError> {
    let rows = body.poses.rows();
    if rows.is_empty() {
        return Ok(());
    }
    let entity = body_entity(body, side);
    let [red, green, blue, opacity] = [FIRST, SECOND][side];
    let size = if side == 0 { 1.0 } else { LARGER };
    for (number, surface) in body.surfaces.iter().enumerate() {
        let mesh = Mesh3D::new(surface.vertices.iter().map(|vertex| vertex.map(|part| size * part)))
            .with_vertex_normals(surface.normals.iter().copied())
            .with_triangle_indices(surface.triangles.iter().copied())
            .with_albedo_factor(Rgba32::from_unmultiplied_rgba(red, green, blue, opacity));
        stream.once(store, &format!("{entity}/shape/{number}"), &[], &mesh)?;
    }
    let length = 1.3 * extent(body);
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| single(&(axis * length)));
    // The second's go through the first's.
    let radius = narrow(length * if side == 0 { 0.014 } else { 0.007 });
    let arrows = Arrows3D::from_vectors(axes)
        .with_radii([Radius::new_scene_units(radius)])
        .with_colors([Color::from_rgb(red, green, blue)])
        .with_labels(["x", "y", "z"])
        .with_show_labels(side == 0 && body.surfaces.is_empty());
    stream.once(store, &format!("{entity}/axes"), &[], &arrows)?;
    let pose = |row: &(f64, [Pose; 2])| row.1[side];
    let turns = rows.iter().map(|row| {
        let [w, x, y, z] = pose(row).attitude;
        quaternion(UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z)))
    });
    let places = rows.iter().map(|row| single(&pose(row).position.map_or(place, Vector3::from)));
    let transform = Transform3D::update_fields().with_many_quaternion(turns).with_many_translation(places);
    let columns = transform.columns_of_unit_batches().map_err(|error| stream.refused(error))?;
    let times = [sim_time(rows.iter().map(|(time_s, _)| nanoseconds(*time_s)).collect())];
    stream.columns(store, &entity, Rows { count: rows.len(), times: &times }, columns)
}

/// Radius of the sphere that holds a body, m; 1 of what has no surface.
pub(super) fn extent(body: &OverlaidBody) -> f64 {
    let extent = body.surfaces.iter().map(crate::body::Surface::extent).fold(0.0, f64::max);
    if extent > 0.0 { extent } else { 1.0 }
}

/// The viewer has no logarithmic axis: powers of ten are plotted.
fn write_curve<W: Write>(stream: &mut Stream<W>, store: Store, curve: &DifferenceCurve) -> Result<(), RecordingError> {
    let [difference, limit] = curve_entities(curve);
    let [red, green, blue, _] = SECOND;
    let style = SeriesLines::new().with_names(["difference"]).with_colors([Color::from_rgb(red, green, blue)]);
    stream.once(store, &difference, &[], &style.with_widths([1.5_f32]))?;
    let drawn = || curve.points.iter().filter(|(_, value)| *value > 0.0 && value.is_finite());
    let values: Vec<f64> = drawn().map(|(_, value)| libm::log10(*value)).collect();
    if !values.is_empty() {
        let times = [sim_time(drawn().map(|(time_s, _)| nanoseconds(*time_s)).collect())];
        let rows = Rows { count: values.len(), times: &times };
        stream.columns(store, &difference, rows, [scalars(&[values])])?;
    }
    let (Some(value), Some((from_s, _)), Some((to_s, _))) =
        (curve.limit.filter(|limit| *limit > 0.0), curve.points.first(), curve.points.last())
    else {
        return Ok(());
    };
    let style = SeriesLines::new().with_names(["limit"]).with_colors([Color::from_rgb(200, 200, 200)]);
    stream.once(store, &limit, &[], &style)?;
    let times = [sim_time([from_s, to_s].map(|time_s| nanoseconds(*time_s)).to_vec())];
    stream.columns(store, &limit, Rows { count: 2, times: &times }, [scalars(&[vec![libm::log10(value); 2]])])
}
