use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use re_chunk::external::arrow::array::{Float64Array, ListArray};
use re_chunk::external::arrow::buffer::OffsetBuffer;
use re_chunk::external::arrow::datatypes::{DataType, Field};
use re_chunk::{TimeColumn, Timeline};
use re_log_types::TimeType;
use re_sdk_types::SerializedComponentColumn;
use re_sdk_types::archetypes::Scalars;
use re_sdk_types::components::RotationQuat;
use re_sdk_types::datatypes::Quaternion;

/// Name of the timeline of simulated time.
pub(super) const SIM_TIME: &str = "sim_time";

/// Name of the timeline of sample numbers.
pub(super) const STEP: &str = "step";

/// Both timelines of a chunk: `stamps` in ns and the numbers of the samples, both ascending.
pub(super) fn timelines(stamps: Vec<i64>, steps: Vec<i64>) -> [TimeColumn; 2] {
    [sim_time(stamps), TimeColumn::new(Some(true), Timeline::new(STEP, TimeType::Sequence), steps.into())]
}

/// The timeline of simulated time: `stamps` in ns, ascending.
pub(super) fn sim_time(stamps: Vec<i64>) -> TimeColumn {
    TimeColumn::new(Some(true), Timeline::new(SIM_TIME, TimeType::DurationNs), stamps.into())
}

/// The columns of one channel, one list a row. Built by hand: the archetype's own way costs ten times as much.
pub(super) fn scalars(columns: &[Vec<f64>]) -> SerializedComponentColumn {
    let rows = columns.first().map_or(0, Vec::len);
    let values = match columns {
        [single] => single.clone(),
        [x, y, z] => interleaved(rows, [x, y, z]),
        [w, x, y, z] => interleaved(rows, [w, x, y, z]),
        several => (0..rows).flat_map(|row| several.iter().map(move |column| column[row])).collect(),
    };
    let offsets = OffsetBuffer::from_repeated_length(columns.len(), rows);
    let field = Arc::new(Field::new_list_field(DataType::Float64, true));
    let list = ListArray::new(field, offsets, Arc::new(Float64Array::from(values)), None);
    SerializedComponentColumn::new(list, Scalars::descriptor_scalars())
}

/// Row after row.
fn interleaved<const N: usize>(rows: usize, columns: [&Vec<f64>; N]) -> Vec<f64> {
    let mut values = vec![0.0; N * rows];
    for (place, column) in columns.into_iter().enumerate() {
        for (row, value) in values.as_chunks_mut::<N>().0.iter_mut().zip(column) {
            row[place] = *value;
        }
    }
    values
}

/// For the picture, which is f32.
#[expect(clippy::cast_possible_truncation, reason = "pictures need no more")]
pub(super) fn single(vector: &Vector3<f64>) -> [f32; 3] {
    [vector.x as f32, vector.y as f32, vector.z as f32]
}

/// For the picture, which is f32.
#[expect(clippy::cast_possible_truncation, reason = "pictures need no more")]
pub(super) const fn narrow(value: f64) -> f32 {
    value as f32
}

/// For the picture, which is f32.
pub(super) fn quaternion(turn: UnitQuaternion<f64>) -> RotationQuat {
    let [x, y, z, w] = [turn.i, turn.j, turn.k, turn.w].map(narrow);
    RotationQuat(Quaternion::from_xyzw([x, y, z, w]))
}
