use re_chunk::{Chunk, ComponentIdentifier, RowId, TimelineName};
use re_sdk_types::archetypes::Transform3D;
use re_sdk_types::components::{
    RotationAxisAngle, RotationQuat, TransformFrameId, TransformMat3x3, TransformRelation, Translation3D,
};
use re_sdk_types::{Component, datatypes};

use super::super::unpack;
use crate::recording::foreign::attitudes;

/// When a row is, ns, and which it is.
pub(super) type Row = (i64, RowId);

/// What a chunk says of transforms, row by row.
#[derive(Debug, Default)]
pub(super) struct Transforms {
    pub translations: Vec<(Row, [f64; 3])>,
    /// w, x, y, z, as the file has them.
    pub quaternions: Vec<(Row, [f64; 4])>,
    /// Made of axis and angle, or of a matrix: of either sign.
    pub turns: Vec<(Row, [f64; 4])>,
    /// Whether they make components in the child's axes of those in the parent's.
    pub inverted: Vec<(Row, bool)>,
    pub children: Vec<(Row, String)>,
    pub parents: Vec<(Row, String)>,
}

impl Transforms {
    /// Whether a chunk has transforms that turn or move something.
    pub fn are_in(chunk: &Chunk) -> bool {
        let parts = [
            Transform3D::descriptor_translation(),
            Transform3D::descriptor_quaternion(),
            Transform3D::descriptor_rotation_axis_angle(),
            Transform3D::descriptor_mat3x3(),
        ];
        parts.iter().any(|part| chunk.component_descriptors().any(|found| found.component == part.component))
    }

    /// Reads a chunk that is on `timeline`.
    ///
    /// # Errors
    /// If a row holds what is no transform.
    pub fn of(chunk: &Chunk, timeline: TimelineName) -> Result<Self, String> {
        unpack::guarded(|| {
            let mut transforms = Self {
                translations: rows(chunk, timeline, &Transform3D::descriptor_translation(), translation)?,
                quaternions: rows(chunk, timeline, &Transform3D::descriptor_quaternion(), quaternion)?,
                turns: rows(chunk, timeline, &Transform3D::descriptor_rotation_axis_angle(), axis_angle)?,
                inverted: rows(chunk, timeline, &Transform3D::descriptor_relation(), |relation| {
                    is_inverted(*relation)
                })?,
                children: rows(chunk, timeline, &Transform3D::descriptor_child_frame(), frame)?,
                parents: rows(chunk, timeline, &Transform3D::descriptor_parent_frame(), frame)?,
            };
            for (row, turn) in rows(chunk, timeline, &Transform3D::descriptor_mat3x3(), matrix)? {
                let turn = turn.ok_or_else(|| format!("the matrix at {} ns is no rotation", row.0))?;
                transforms.turns.push((row, turn));
            }
            Ok(transforms)
        })
    }
}

/// The rows of a component, each with its time; rows that hold none are passed over.
fn rows<C: Component, T>(
    chunk: &Chunk,
    timeline: TimelineName,
    descriptor: &re_sdk_types::ComponentDescriptor,
    read: impl Fn(&C) -> T,
) -> Result<Vec<(Row, T)>, String> {
    let component: ComponentIdentifier = descriptor.component;
    let indices: Vec<_> = chunk.iter_component_indices(timeline, component).collect();
    let values = chunk.iter_component::<C>(component);
    let (mut rows, mut count) = (Vec::new(), 0);
    for ((time, row), value) in indices.iter().zip(values) {
        count += 1;
        match value.as_slice() {
            [] => {}
            [single] => rows.push(((time.as_i64(), *row), read(single))),
            several => return Err(format!("{} of {component} in one row", several.len())),
        }
    }
    if count != indices.len() {
        return Err(format!("{component} is of another type than Rerun's"));
    }
    Ok(rows)
}

fn translation(translation: &Translation3D) -> [f64; 3] {
    translation.0.0.map(f64::from)
}

fn quaternion(RotationQuat(datatypes::Quaternion([x, y, z, w])): &RotationQuat) -> [f64; 4] {
    [*w, *x, *y, *z].map(f64::from)
}

fn axis_angle(turn: &RotationAxisAngle) -> [f64; 4] {
    let [x, y, z] = turn.0.axis.0.map(f64::from);
    let (sine, cosine) = libm::sincos(f64::from(turn.0.angle.radians) / 2.0);
    let scale = sine / (x * x + y * y + z * z).sqrt();
    // Whichever axis it turns nothing about.
    if sine == 0.0 { [cosine, 0.0, 0.0, 0.0] } else { [cosine, x * scale, y * scale, z * scale] }
}

/// Columns, one after the other.
fn matrix(matrix: &TransformMat3x3) -> Option<[f64; 4]> {
    let columns = matrix.0.0.map(f64::from);
    attitudes::from_matrix(std::array::from_fn(|place| columns[3 * (place % 3) + place / 3]))
}

fn is_inverted(relation: TransformRelation) -> bool {
    relation == TransformRelation::ChildFromParent
}

fn frame(frame: &TransformFrameId) -> String {
    frame.as_str().to_owned()
}
