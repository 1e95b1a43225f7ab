//! Mass properties of a whole from pieces whose own are known: what particles, solids and meshes have in common.

use nalgebra::{Matrix3, Vector3};

use super::error::{finite, positive};
use super::{BodyError, MassProperties};
use crate::numerics::Compensated;

/// A piece of a body. A hole has negative mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// kg.
    pub mass: f64,
    /// Of mass, body axes, m.
    pub centre: Vector3<f64>,
    /// ∫ r rᵀ dm about its centre, body axes, kg m². Unlike the inertia tensor it shrinks to nothing in the
    /// directions in which the piece is thin, so that a moment of a thin body is never a difference.
    pub second_moment: Matrix3<f64>,
}

/// The mass properties of all pieces together, about their common centre of mass.
pub(super) fn assemble(pieces: &[Piece]) -> Result<MassProperties, BodyError> {
    let mass = positive("total mass", compensated_sum(pieces.iter().map(|piece| piece.mass)), "kg")?;
    let centre = finite("centre of mass", centre_of_mass(pieces, mass))?;
    let mut second_moment = Matrix3::zeros();
    for (row, column) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
        let element = compensated_sum(pieces.iter().flat_map(|piece| {
            let arm = piece.centre - centre;
            [piece.second_moment[(row, column)], piece.mass * arm[row] * arm[column]]
        }));
        second_moment[(row, column)] = element;
        second_moment[(column, row)] = element;
    }
    let body = MassProperties::from_tensor(Some(mass), inertia_from_second_moment(&second_moment))?;
    body.shifted(centre)
}

/// Σ m p / Σ m, in two passes: the second, about the first's result, removes the rounding of a distant origin.
pub(super) fn centre_of_mass(pieces: &[Piece], mass: f64) -> Vector3<f64> {
    let mean_from = |origin: Vector3<f64>| {
        Vector3::from([0, 1, 2].map(|axis| {
            compensated_sum(pieces.iter().map(|piece| piece.mass * (piece.centre[axis] - origin[axis]))) / mass
        }))
    };
    let first = mean_from(Vector3::zeros());
    first + mean_from(first)
}

/// I = tr(C) E − C for C = ∫ r rᵀ dm; each diagonal element a sum of two, none a difference.
pub(super) fn inertia_from_second_moment(second_moment: &Matrix3<f64>) -> Matrix3<f64> {
    let [xx, yy, zz] = second_moment.diagonal().into();
    let mut tensor = -second_moment;
    tensor.set_diagonal(&Vector3::new(yy + zz, zz + xx, xx + yy));
    tensor
}

/// The sum of the terms, without the rounding of each addition.
pub(super) fn compensated_sum(terms: impl IntoIterator<Item = f64>) -> f64 {
    let mut sum = Compensated::default();
    terms.into_iter().for_each(|term| sum.add(term));
    sum.value()
}
