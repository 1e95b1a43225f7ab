use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::body::{AngularVelocity, Attitude, State};
use crate::propagation::States;

/// The states of a batch, one at a time. What was not propagated stays as it was at t = 0: it is constant, or no channel
/// looks at it.
pub(super) struct Batch<'a> {
    pub times: &'a [f64],
    pub states: &'a States,
    pub initial: &'a State,
}

impl Batch<'_> {
    #[inline(always)]
    pub fn state(&self, index: usize) -> State {
        let vector = |columns: &[Vec<f64>; 3], constant: &Vector3<f64>| {
            if columns[0].is_empty() { *constant } else { Vector3::from_fn(|row, _| columns[row][index]) }
        };
        State {
            attitude: Attitude::from_world_from_body(self.attitude(index)),
            angular_velocity: AngularVelocity::from_vector(vector(&self.states.angular_velocity, &Vector3::zeros())),
            position: vector(&self.states.position, &self.initial.position),
            velocity: vector(&self.states.velocity, &self.initial.velocity),
        }
    }

    /// σ of a sphere inside the body, in principal axes.
    pub fn inner(&self, index: usize) -> Vector3<f64> {
        Vector3::from_fn(|row, _| self.states.inner[row].get(index).copied().unwrap_or_default())
    }

    /// L of particles on springs, world axes, N m s; none of a rigid body.
    pub fn momentum_of_particles(&self, index: usize) -> Option<Vector3<f64>> {
        let [x, y, z] = &self.states.cloud.momentum;
        Some(Vector3::new(*x.get(index)?, *y.get(index)?, *z.get(index)?))
    }

    /// World from principal; the identity where no attitude was propagated, as then no channel looks at it.
    #[inline(always)]
    pub fn attitude(&self, index: usize) -> UnitQuaternion<f64> {
        let [w, x, y, z] = &self.states.attitude;
        if w.is_empty() {
            return UnitQuaternion::identity();
        }
        UnitQuaternion::new_unchecked(Quaternion::new(w[index], x[index], y[index], z[index]))
    }

    /// Fills three columns with what `value` makes of time and state.
    #[inline(always)]
    pub fn vectors(&self, columns: &mut [Vec<f64>], value: impl Fn(f64, &State) -> Vector3<f64>) {
        self.vectors_at(columns, |_, time, state| value(time, state));
    }

    /// Fills three columns with what `value` makes of index, time and state.
    #[inline(always)]
    pub fn vectors_at(&self, columns: &mut [Vec<f64>], value: impl Fn(usize, f64, &State) -> Vector3<f64>) {
        for column in columns.iter_mut() {
            column.resize(self.times.len(), 0.0);
        }
        let [x, y, z] = columns else { return };
        for (index, (((x, y), z), time)) in x.iter_mut().zip(y).zip(z).zip(self.times).enumerate() {
            [*x, *y, *z] = value(index, *time, &self.state(index)).into();
        }
    }

    /// Fills a column with what `value` makes of index, time and state.
    #[inline(always)]
    pub fn scalars(&self, columns: &mut [Vec<f64>], mut value: impl FnMut(usize, f64, &State) -> f64) {
        let [column] = columns else { return };
        column.resize(self.times.len(), 0.0);
        for (index, (place, time)) in column.iter_mut().zip(self.times).enumerate() {
            *place = value(index, *time, &self.state(index));
        }
    }
}
