use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use super::Scheme;
use crate::body::{AngularVelocity, Attitude, State};
use crate::numerics::so3::cross_product_matrix;
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values, state, values_of};

/// What lecture notes do first, `[Baraff97]`: R + h Ṙ, ω + h ω̇, and R made a rotation again. It gains energy.
pub(super) struct EulerNaive;

impl Scheme for EulerNaive {
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError> {
        let push = equations.push(time, values);
        let State { attitude, angular_velocity, position, velocity } = state(values);
        let omega = angular_velocity.in_body();
        let before = attitude.world_from_body();
        let matrix = before.to_rotation_matrix();
        let stretched = matrix.matrix() * (Matrix3::identity() + step * cross_product_matrix(&omega));
        let after = UnitQuaternion::from_rotation_matrix(&orthogonalised(&stretched));
        // Of q and −q that which goes on from where the last one was.
        let after = if after.coords.dot(&before.coords) < 0.0 {
            UnitQuaternion::new_unchecked(-after.into_inner())
        } else {
            after
        };
        Ok(values_of(&State {
            attitude: Attitude::from_world_from_body(after),
            angular_velocity: AngularVelocity::from_vector(
                omega + step * equations.euler().acceleration(&omega, &push.moment),
            ),
            position: position + step * velocity,
            velocity: velocity + step * push.acceleration,
        }))
    }
}

/// The rotation whose first column points as the matrix's does, and the second as nearly as may be: Gram and Schmidt.
fn orthogonalised(matrix: &Matrix3<f64>) -> Rotation3<f64> {
    let first = matrix.column(0).normalize();
    let second = matrix.column(1);
    let second = (second - first * first.dot(&second)).normalize();
    Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[first, second, first.cross(&second)]))
}
