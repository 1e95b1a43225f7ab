use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::archetypes::{LineStrips3D, Points3D};
use re_sdk_types::components::Radius;

use super::columns::{narrow, single};
use super::palette;
use super::stream::{Rows, Store, Stream};
use crate::recording::RecordingError;
use crate::recording::picture::Picture;
use crate::scenario::{Plan, Watched};
use crate::telemetry::{Channel, PointKind, Samples};

/// Radius of a particle, in units of the largest body's extent: larger than that of the place where a rigid body has it.
const POINT: f64 = 0.09;
/// Radius of a spring's line, in the same units.
const SPRING: f64 = 0.008;

/// The particles of one body, and the springs between every two.
struct Cloud {
    points: String,
    springs: String,
    /// Where the samples of each stand.
    subjects: Vec<usize>,
}

/// All particles on springs that are recorded one by one, at the picture's rate.
pub(super) struct Particles(Vec<Cloud>);

impl Particles {
    /// Logs what of them does not change.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn begin<W: Write>(
        stream: &mut Stream<W>,
        store: Store,
        plan: &Plan,
        picture: &Picture,
    ) -> Result<Self, RecordingError> {
        let mut clouds = Vec::new();
        for (number, (body, drawing)) in plan.bodies.iter().zip(&picture.bodies).enumerate() {
            let is_of_body = |watched: &Watched<'_>| {
                watched.body.name == body.name
                    && watched.point.is_some_and(|point| matches!(point.kind, PointKind::Particle(_)))
            };
            let each = plan.watched().enumerate().filter(|(_, watched)| is_of_body(watched));
            let subjects: Vec<usize> = each.map(|(subject, _)| subject).collect();
            if subjects.is_empty() {
                continue;
            }
            let name = &body.name;
            let cloud = Cloud {
                points: format!("/world/particles/{name}"),
                springs: format!("/world/springs/{name}"),
                subjects,
            };
            let radius = |part: f64| Radius::new_scene_units(narrow(part * drawing.extent));
            let points = Points3D::update_fields()
                .with_radii([radius(POINT)])
                .with_colors([palette::opaque(palette::of_body(number, 0))]);
            let springs = LineStrips3D::update_fields()
                .with_radii([radius(SPRING)])
                .with_colors([palette::opaque(palette::WORLD)]);
            stream.once(store, &cloud.points, &[], &points)?;
            stream.once(store, &cloud.springs, &[], &springs)?;
            clouds.push(cloud);
        }
        Ok(Self(clouds))
    }

    /// Logs where they are in the samples at `indices`.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn write<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): (&[usize], &Samples),
    ) -> Result<(), RecordingError> {
        for cloud in &self.0 {
            let columns = |subject: &usize| samples.bodies.get(*subject)?.channel(Channel::Position);
            let positions: Vec<&[Vec<f64>]> = cloud.subjects.iter().filter_map(columns).collect();
            let place = |columns: &&[Vec<f64>], index: usize| {
                single(&Vector3::from_fn(|axis, _| columns.get(axis).map_or(f64::NAN, |column| column[index])))
            };
            let frame = |index: usize| positions.iter().map(move |columns| place(columns, index)).collect::<Vec<_>>();
            let frames: Vec<Vec<[f32; 3]>> = indices.iter().map(|index| frame(*index)).collect();
            let points = Points3D::update_fields()
                .with_positions(frames.iter().flatten().copied())
                .columns(frames.iter().map(Vec::len))
                .map_err(|error| stream.refused(error))?;
            stream.columns(store, &cloud.points, rows, points)?;
            let strips: Vec<Vec<[[f32; 3]; 2]>> = frames.iter().map(|frame| pairs(frame)).collect();
            let springs = LineStrips3D::update_fields()
                .with_strips(strips.iter().flatten().copied())
                .columns(strips.iter().map(Vec::len))
                .map_err(|error| stream.refused(error))?;
            stream.columns(store, &cloud.springs, rows, springs)?;
        }
        Ok(())
    }
}

/// From each to all after it.
fn pairs(places: &[[f32; 3]]) -> Vec<[[f32; 3]; 2]> {
    let after = |(number, from): (usize, &[f32; 3])| {
        let from = *from;
        places[number + 1..].iter().map(move |to| [from, *to])
    };
    places.iter().enumerate().flat_map(after).collect()
}
