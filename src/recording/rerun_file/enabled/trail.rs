use std::io::Write;

use re_sdk_types::archetypes::LineStrips3D;
use re_sdk_types::components::LineStrip3D;

use super::columns::timelines;
use super::stream::{Rows, Store, Stream};
use crate::recording::RecordingError;
use crate::recording::picture::Picture;
use crate::scenario::Plan;

/// How a point's trace is cut into rows. Each row is a short strip; the layout shows those of a window up to now, so
/// that a trail costs as much as its length, whatever the time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cut {
    /// How many pictures a row spans.
    pub(super) pictures: usize,
    /// How long the window is, s; `None`: from the beginning.
    pub(super) window_s: Option<f64>,
}

impl Cut {
    /// Rows that the viewer draws at once without stuttering.
    const ROWS: u64 = 1500;

    /// Pictures in a row, at most: the trail lags behind by as much.
    const LONGEST: u64 = 4;

    /// All of the run if it is short enough, else the last part of it.
    pub(super) fn new(plan: &Plan, picture: &Picture) -> Self {
        let pictures = plan.grid.len() / picture.stride.max(1);
        let span = pictures.div_ceil(Self::ROWS).clamp(1, Self::LONGEST);
        let is_whole = pictures <= Self::ROWS * span;
        let window_s = (!is_whole).then(|| {
            let samples = u32::try_from(Self::ROWS * span * picture.stride).unwrap_or(u32::MAX);
            f64::from(samples) * plan.grid.mean_interval()
        });
        Self { pictures: usize::try_from(span).unwrap_or(1), window_s }
    }
}

/// The trace of one point, as it grows.
pub(super) struct Trail {
    entity: String,
    pictures: usize,
    points: Vec<[f32; 3]>,
}

impl Trail {
    /// Empty; rows go to `entity`.
    pub(super) fn new(entity: String, cut: Cut) -> Self {
        Self { entity, pictures: cut.pictures, points: Vec::with_capacity(cut.pictures + 1) }
    }

    /// Continues it through `points`, each with stamp (ns) and number of its sample.
    ///
    /// # Errors
    /// If the rows cannot be written.
    pub(super) fn write<W: Write>(
        &mut self,
        stream: &mut Stream<W>,
        store: Store,
        points: impl Iterator<Item = (i64, i64, [f32; 3])>,
    ) -> Result<(), RecordingError> {
        let (mut stamps, mut steps, mut strips) = (Vec::new(), Vec::new(), Vec::new());
        for (stamp, step, point) in points {
            self.points.push(point);
            if self.points.len() > self.pictures {
                stamps.push(stamp);
                steps.push(step);
                strips.push(LineStrip3D::from_iter(self.points.iter().copied()));
                self.points.clear();
                self.points.push(point);
            }
        }
        if strips.is_empty() {
            return Ok(());
        }
        let rows = Rows { count: strips.len(), times: &timelines(stamps, steps) };
        let columns = LineStrips3D::update_fields()
            .with_strips(strips)
            .columns_of_unit_batches()
            .map_err(|error| stream.refused(error))?;
        stream.columns(store, &self.entity, rows, columns)
    }
}
