use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::archetypes::LineStrips3D;

use super::columns::single;
use super::stream::{Rows, Store, Stream};
use crate::recording::RecordingError;
use crate::recording::picture::{BodyPicture, Cord, attitude};
use crate::telemetry::BodySamples;

/// The springs that hold a body, as lines.
pub(super) struct Cords {
    entity: String,
    cords: Vec<Cord>,
}

impl Cords {
    /// Of a body's picture; none where nothing holds it.
    pub(super) fn new(entity: &str, drawing: &BodyPicture) -> Option<Self> {
        let cords = drawing.cords.clone();
        (!cords.is_empty()).then(|| Self { entity: entity.to_owned(), cords })
    }

    /// Logs them at the samples `indices`, `places` being those of the reference point.
    ///
    /// # Errors
    /// If they cannot be written.
    pub(super) fn write<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): (&[usize], &BodySamples),
        places: &[Vector3<f64>],
    ) -> Result<(), RecordingError> {
        let mut lines = Vec::with_capacity(indices.len() * self.cords.len());
        for (index, place) in indices.iter().zip(places) {
            let Some(turn) = attitude(samples, *index) else { return Ok(()) };
            lines
                .extend(self.cords.iter().map(|cord| [cord.anchor, place + turn * cord.point].map(|end| single(&end))));
        }
        let columns = LineStrips3D::update_fields()
            .with_strips(lines)
            .columns(indices.iter().map(|_| self.cords.len()))
            .map_err(|error| stream.refused(error))?;
        stream.columns(store, &self.entity, rows, columns)
    }
}
