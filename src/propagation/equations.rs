use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::body::{AngularVelocity, Attitude, State};
use crate::dynamics::{DynamicsError, EulerEquations, Problem, Schedule, Span, TorqueModel, attitude_rate};
use crate::propagation::States;

/// ω, q, x, v one after the other.
pub(super) type Values = [f64; 13];

/// Where each quantity stands.
pub(super) const RATES: std::ops::Range<usize> = 0..3;
pub(super) const ATTITUDE: std::ops::Range<usize> = 3..7;
pub(super) const POSITION: std::ops::Range<usize> = 7..10;
pub(super) const VELOCITY: std::ops::Range<usize> = 10..13;

/// The equations of motion as a derivative to be asked for at any time and state, with a count of how often it was.
pub(super) struct Equations {
    problem: Problem,
    euler: EulerEquations,
    schedule: Schedule,
    model: Option<Box<dyn TorqueModel + Send>>,
    with_attitude: bool,
    /// The current span's number, and what acts in it.
    current: usize,
    span: Span,
    /// Derivatives worked out so far.
    pub evaluations: u64,
}

/// What acts at one instant.
pub(super) struct Push {
    /// N m, principal axes.
    pub moment: Vector3<f64>,
    /// Of the reference point, m/s², world axes; zero where no translation is wanted.
    pub acceleration: Vector3<f64>,
}

impl Equations {
    pub fn new(problem: &Problem, model: Option<Box<dyn TorqueModel + Send>>) -> Result<Self, DynamicsError> {
        let schedule = Schedule::new(problem)?;
        if let Some(error) = problem.moves_inside() {
            return Err(error);
        }
        Ok(Self {
            euler: EulerEquations::new(problem.moments),
            with_attitude: problem.wants_attitude || schedule.needs_attitude() || model.is_some(),
            span: schedule.span(0),
            schedule,
            model,
            problem: problem.clone(),
            current: 0,
            evaluations: 0,
        })
    }

    /// The values at t = 0.
    pub fn initial(&self) -> Values {
        values_of(&self.problem.initial)
    }

    /// Euler's equations of this body.
    pub fn euler(&self) -> &EulerEquations {
        &self.euler
    }

    /// The span whose loads act now.
    pub fn span(&self) -> &Span {
        &self.span
    }

    /// Goes on to the next span; the last one has no end to go over.
    pub fn next_span(&mut self) {
        self.current += 1;
        self.span = self.schedule.span(self.current);
    }

    /// The derivative under the loads of the current span, whatever the time.
    pub fn derivative(&mut self, time: f64, values: &Values) -> Values {
        let push = self.push(time, values);
        let mut derivative = Values::default();
        let omega = vector(values, RATES);
        derivative[RATES].copy_from_slice(self.euler.acceleration(&omega, &push.moment).as_slice());
        if self.with_attitude {
            derivative[ATTITUDE].copy_from_slice(&attitude_rate(quaternion(values), &omega));
        }
        if self.problem.wants_translation {
            derivative[POSITION].copy_from_slice(&values[VELOCITY]);
            derivative[VELOCITY].copy_from_slice(push.acceleration.as_slice());
        }
        derivative
    }

    /// What the loads of the current span do, whatever the time: one evaluation.
    pub fn push(&mut self, time: f64, values: &Values) -> Push {
        self.evaluations += 1;
        let loads = &self.span.loads;
        let body_from_world = if self.with_attitude { body_from_world(values) } else { Matrix3::identity() };
        let mut moment = loads.moment(self.problem.moments, time, &body_from_world, &vector(values, RATES));
        if let Some(model) = &self.model {
            moment += model.moment(time, &state(values)).in_body();
        }
        let mut acceleration = loads.acceleration(time, &body_from_world);
        for load in &loads.general {
            let state = state(values);
            moment += load.moment(time, &state);
            if let (true, Some(mass)) = (self.problem.wants_translation, self.problem.mass) {
                acceleration += load.force(time, &state) / mass;
            }
        }
        Push { moment, acceleration }
    }

    /// Makes room for states at this many times.
    pub fn reset(&self, states: &mut States, count: usize) {
        states.reset(count, self.problem.wants_attitude, self.problem.wants_translation);
    }

    /// Writes values into a row of the columns that are wanted.
    pub fn write(&self, values: &Values, states: &mut States, row: usize) {
        let put = |columns: &mut [Vec<f64>], range: std::ops::Range<usize>| {
            for (column, value) in columns.iter_mut().zip(&values[range]) {
                column[row] = *value;
            }
        };
        put(&mut states.angular_velocity, RATES);
        if self.problem.wants_attitude {
            put(&mut states.attitude, ATTITUDE);
        }
        if self.problem.wants_translation {
            put(&mut states.position, POSITION);
            put(&mut states.velocity, VELOCITY);
        }
    }
}

/// Brings q back to unit length.
pub(super) fn normalise(values: &mut Values) {
    let length = values[ATTITUDE].iter().map(|component| component * component).sum::<f64>().sqrt();
    for component in &mut values[ATTITUDE] {
        *component /= length;
    }
}

/// Three of the values.
pub(super) fn vector(values: &Values, range: std::ops::Range<usize>) -> Vector3<f64> {
    Vector3::from_column_slice(&values[range])
}

fn quaternion(values: &Values) -> [f64; 4] {
    [values[3], values[4], values[5], values[6]]
}

/// Rᵀ, for a q whose length a stage may have left.
fn body_from_world(values: &Values) -> Matrix3<f64> {
    let [w, x, y, z] = quaternion(values);
    let scale = 2.0 / (w * w + x * x + y * y + z * z);
    let (xx, yy, zz) = (scale * x * x, scale * y * y, scale * z * z);
    let (xy, yz, zx) = (scale * x * y, scale * y * z, scale * z * x);
    let (wx, wy, wz) = (scale * w * x, scale * w * y, scale * w * z);
    Matrix3::new(
        1.0 - (yy + zz),
        xy + wz,
        zx - wy,
        xy - wz,
        1.0 - (xx + zz),
        yz + wx,
        zx + wy,
        yz - wx,
        1.0 - (xx + yy),
    )
}

/// The values as a state, its quaternion of unit length.
pub(super) fn state(values: &Values) -> State {
    let [w, x, y, z] = quaternion(values);
    State {
        attitude: Attitude::from_world_from_body(UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))),
        angular_velocity: AngularVelocity::from_vector(vector(values, RATES)),
        position: vector(values, POSITION),
        velocity: vector(values, VELOCITY),
    }
}

/// A state as values.
pub(super) fn values_of(state: &State) -> Values {
    let mut values = Values::default();
    values[RATES].copy_from_slice(state.angular_velocity.in_body().as_slice());
    values[ATTITUDE].copy_from_slice(&state.attitude.wxyz());
    values[POSITION].copy_from_slice(state.position.as_slice());
    values[VELOCITY].copy_from_slice(state.velocity.as_slice());
    values
}
