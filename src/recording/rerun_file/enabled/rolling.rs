use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::archetypes::{Arrows3D, Points3D, Transform3D};

use super::columns::{quaternion, single};
use super::poinsot::PoinsotEntities;
use super::stream::{Rows, Store, Stream};
use super::trail::{Cut, Trail};
use crate::recording::RecordingError;
use crate::recording::picture::{Poinsot, attitude, vector};
use crate::telemetry::{BodySamples, Channel};

/// What moves of Poinsot's construction, at the picture's rate.
pub(super) struct Rolling {
    entities: PoinsotEntities,
    unit: f64,
    normal: Vector3<f64>,
    herpolhode: Trail,
}

impl Rolling {
    pub(super) fn new(name: &str, poinsot: &Poinsot, cut: Cut) -> Self {
        let entities = PoinsotEntities::new(name);
        let herpolhode = Trail::new(entities.herpolhode.clone(), cut);
        Self { entities, unit: poinsot.unit, normal: poinsot.normal, herpolhode }
    }

    /// Logs the samples `indices` of a batch; `when` says stamp (ns) and number of each.
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
        let Some(omega) = samples.channel(Channel::AngularVelocity) else { return Ok(()) };
        let turns: Vec<_> = indices.iter().filter_map(|index| attitude(samples, *index)).collect();
        let omega = indices.iter().map(|index| vector(omega, *index) / self.unit);
        let contacts: Vec<_> = turns.iter().zip(omega).map(|(turn, omega)| single(&(turn * omega))).collect();
        let momenta = turns.iter().map(|turn| single(&turn.inverse_transform_vector(&self.normal))).collect();
        let points = when.zip(&contacts).map(|((stamp, step), point)| (stamp, step, *point));
        self.herpolhode.write(stream, store, points)?;
        point_to(stream, store, &self.entities.contact, rows, contacts)?;
        point_to(stream, store, &self.entities.momentum, rows, momenta)?;
        let transform = Transform3D::update_fields().with_many_quaternion(turns.into_iter().map(quaternion));
        let columns = transform.columns_of_unit_batches().map_err(|error| stream.refused(error))?;
        stream.columns(store, &self.entities.ellipsoid, rows, columns)
    }
}

/// Logs an arrow from the centre to each of `tips`, and a point there.
fn point_to<W: Write>(
    stream: &mut Stream<W>,
    store: Store,
    entity: &str,
    rows: Rows<'_>,
    tips: Vec<[f32; 3]>,
) -> Result<(), RecordingError> {
    let points = Points3D::update_fields().with_positions(tips.iter().copied()).columns_of_unit_batches();
    let arrows = Arrows3D::update_fields().with_vectors(tips).columns_of_unit_batches();
    let points = points.map_err(|error| stream.refused(error))?;
    let arrows = arrows.map_err(|error| stream.refused(error))?;
    stream.columns(store, entity, rows, arrows.chain(points))
}
