use nalgebra::{UnitQuaternion, Vector3};

use super::Channel;
use super::batch::Batch;
use crate::body::State;
use crate::dynamics::Problem;

/// Where a probe or an IMU sits in its body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mounting {
    /// From the reference point, principal axes, m.
    pub arm: Vector3<f64>,
    /// Turns the axes that components are along into principal axes: those of the body, or of an IMU.
    pub principal_from_axes: UnitQuaternion<f64>,
    /// Of a body held at its reference point: the gravity that an accelerometer there feels, world axes, m/s². `None` of
    /// a free body, which falls with it.
    pub held_against: Option<Vector3<f64>>,
}

impl Mounting {
    /// Of the reference point of a body of these axes, free until it is [held](Self::held_against).
    #[must_use]
    pub fn at_reference_point(body_from_principal: UnitQuaternion<f64>) -> Self {
        Self { arm: Vector3::zeros(), principal_from_axes: body_from_principal.inverse(), held_against: None }
    }

    /// What `channel` reads there, each in the axes that it is recorded in, and not turned to them from others.
    pub(super) fn read(&self, problem: &Problem, channel: Channel, batch: &Batch<'_>, columns: &mut [Vec<f64>]) {
        let arm = &self.arm;
        let to_axes = |in_principal: Vector3<f64>| self.principal_from_axes.inverse_transform_vector(&in_principal);
        let to_body = |state: &State, in_world: Vector3<f64>| state.attitude.to_body(&in_world);
        let turned = |state: &State| state.angular_velocity.in_body().cross(arm);
        match channel {
            Channel::Position => batch.vectors(columns, |_, state| state.position + state.attitude.to_world(arm)),
            Channel::PositionBody => batch.vectors(columns, |_, state| to_axes(to_body(state, state.position) + arm)),
            Channel::Velocity => {
                batch.vectors(columns, |_, state| state.velocity + state.attitude.to_world(&turned(state)));
            }
            Channel::VelocityBody => {
                batch.vectors(columns, |_, state| to_axes(to_body(state, state.velocity) + turned(state)));
            }
            Channel::Acceleration => batch.vectors_at(columns, |index, time, state| {
                let about = self.about_reference_point(problem, time, state, &batch.inner(index));
                self.of_reference_point(problem, time, state) + state.attitude.to_world(&about)
            }),
            Channel::AccelerationBody => batch.vectors_at(columns, |index, time, state| {
                let about = self.about_reference_point(problem, time, state, &batch.inner(index));
                to_axes(to_body(state, self.of_reference_point(problem, time, state)) + about)
            }),
            Channel::Gyroscope => batch.vectors(columns, |_, state| to_axes(state.angular_velocity.in_body())),
            Channel::Accelerometer => batch.vectors_at(columns, |index, time, state| {
                let about = self.about_reference_point(problem, time, state, &batch.inner(index));
                let stronger = problem.gravity_difference(time, state, arm);
                to_axes(to_body(state, self.felt(problem, time, state)) + about - stronger)
            }),
            // A plan asks it for nothing else.
            _ => batch.vectors(columns, |_, _| Vector3::zeros()),
        }
    }

    /// A, m/s², world axes.
    fn of_reference_point(&self, problem: &Problem, time: f64, state: &State) -> Vector3<f64> {
        match self.held_against {
            Some(_) => Vector3::zeros(),
            None => problem.gravity + problem.load_acceleration(time, state),
        }
    }

    /// A − g, m/s², world axes: of a body that falls freely nothing, to the bit.
    fn felt(&self, problem: &Problem, time: f64, state: &State) -> Vector3<f64> {
        self.held_against.map_or_else(|| problem.load_acceleration(time, state), |gravity| -gravity)
    }

    /// α × r + ω × (ω × r), m/s², principal axes.
    fn about_reference_point(&self, problem: &Problem, time: f64, state: &State, inner: &Vector3<f64>) -> Vector3<f64> {
        if self.arm == Vector3::zeros() {
            return Vector3::zeros();
        }
        let omega = state.angular_velocity.in_body();
        let alpha = problem.angular_acceleration(time, state, inner);
        alpha.cross(&self.arm) + omega.cross(&omega.cross(&self.arm))
    }
}
