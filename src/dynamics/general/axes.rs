//! Constant rotations of what is on a tape.

use nalgebra::UnitQuaternion;

use crate::numerics::{Node, Tape};

/// A vector in other axes.
pub(super) fn rotated(tape: &mut Tape, turn: UnitQuaternion<f64>, vector: [Node; 3]) -> [Node; 3] {
    if turn == UnitQuaternion::identity() {
        return vector;
    }
    let matrix = turn.to_rotation_matrix().into_inner();
    [0, 1, 2].map(|row| {
        let row = tape.vector([matrix[(row, 0)], matrix[(row, 1)], matrix[(row, 2)]]);
        tape.dot(row, vector)
    })
}

/// q times the inverse of a constant rotation.
pub(super) fn times_inverse(tape: &mut Tape, q: [Node; 4], turn: UnitQuaternion<f64>) -> [Node; 4] {
    if turn == UnitQuaternion::identity() {
        return q;
    }
    let turn = turn.inverse();
    let constants = [turn.w, turn.i, turn.j, turn.k].map(|value| tape.constant(value));
    product(tape, q, constants)
}

/// The vector part of the inverse of a constant rotation times q.
pub(super) fn conjugate_times(tape: &mut Tape, turn: UnitQuaternion<f64>, q: [Node; 4]) -> [Node; 3] {
    let turn = turn.inverse();
    let constants = [turn.w, turn.i, turn.j, turn.k].map(|value| tape.constant(value));
    let [_, x, y, z] = product(tape, constants, q);
    [x, y, z]
}

/// p q.
fn product(tape: &mut Tape, [pw, p @ ..]: [Node; 4], [qw, q @ ..]: [Node; 4]) -> [Node; 4] {
    let (both, along) = (tape.product(pw, qw), tape.dot(p, q));
    let (first, second) = (tape.scaled(pw, q), tape.scaled(qw, p));
    let (sum, across) = (tape.sums(first, second), tape.cross(p, q));
    let [x, y, z] = tape.sums(sum, across);
    [tape.difference(both, along), x, y, z]
}
