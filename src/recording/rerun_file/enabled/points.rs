//! Points of bodies in the picture: where they sit, and the ways of those whose position is recorded.

use std::io::Write;

use re_sdk_types::archetypes::Points3D;

use super::columns::{narrow, single};
use super::palette;
use super::scaled::Scaled;
use super::statics::{BodyEntities, line_style};
use super::stream::{Rows, Store, Stream};
use super::trail::{Cut, Trail};
use crate::recording::RecordingError;
use crate::recording::picture::vector;
use crate::scenario::{Plan, PlannedBody, Watched};
use crate::telemetry::{BodySamples, Channel, Point, PointKind};

/// Radius of a point, in units of the largest body's extent.
const RADIUS: f64 = 0.035;

/// Where the way of a point is logged.
pub(super) fn path(point: &Point) -> String {
    format!("/world/path/{}", point.name)
}

/// Whether its position is recorded, along world axes. Particles are drawn where they are, without their ways.
pub(super) fn leaves_path(point: &Point) -> bool {
    matches!(point.kind, PointKind::Mounted(_)) && point.channels.contains(&Channel::Position)
}

/// Logs where the points of `body` sit in it, with their names, and how their ways look: `size` is the largest body's
/// extent, `width` that of a way, m.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    body: &PlannedBody,
    (size, width): (f64, f64),
) -> Result<(), RecordingError> {
    let turn = body.properties.body_from_principal;
    for (number, point) in body.points.iter().enumerate() {
        let colour = palette::of_point(number);
        let PointKind::Mounted(mounting) = &point.kind else { continue };
        let place = Points3D::new([single(&(turn * mounting.arm))])
            .with_radii([narrow(RADIUS * size)])
            .with_colors([palette::opaque(colour)])
            .with_labels([point.own_name()])
            .with_show_labels(true);
        let entities = BodyEntities::new(&body.name);
        stream.once(store, &format!("{}/points/{}", entities.body, point.own_name()), &[], &place)?;
        if leaves_path(point) {
            stream.once(store, &path(point), &[], &line_style(colour, width))?;
        }
    }
    Ok(())
}

/// A point at the picture's rate.
pub(super) struct MovingPoint {
    /// Its way, as it grows; of one whose position is not recorded, none.
    trail: Option<Trail>,
    /// None where nothing is plotted.
    scaled: Option<Scaled>,
}

impl MovingPoint {
    /// Of everything in `plan` that is no body, in the order of recordings, as `scaled` is.
    pub(super) fn all(plan: &Plan, cut: Cut, mut scaled: impl Iterator<Item = Scaled>) -> Vec<Self> {
        let moving = |watched: Watched| {
            let point = watched.point.filter(|point| leaves_path(point));
            Self { trail: point.map(|point| Trail::new(path(point), cut)), scaled: scaled.next() }
        };
        plan.watched().skip(plan.bodies.len()).map(moving).collect()
    }

    /// Logs the samples at `indices`, each with stamp (ns) and number in `when`.
    ///
    /// # Errors
    /// If they cannot be written.
    pub(super) fn write<W: Write>(
        &mut self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): (&[usize], &BodySamples),
        when: impl Iterator<Item = (i64, i64)>,
    ) -> Result<(), RecordingError> {
        if let Some(scaled) = &self.scaled {
            scaled.write(stream, store, rows, (indices, samples))?;
        }
        let (Some(trail), Some(columns)) = (&mut self.trail, samples.channel(Channel::Position)) else { return Ok(()) };
        let points = indices.iter().zip(when);
        trail.write(stream, store, points.map(|(index, (stamp, step))| (stamp, step, single(&vector(columns, *index)))))
    }
}
