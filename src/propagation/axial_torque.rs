use nalgebra::Vector3;

use super::exact::{ExactQuaternion, Motion, QuaternionMap, Rates, fill_columns};
use super::sampling::check_times;
use super::{Ballistic, Effort, FreeRotation, PropagationError, Propagator, States};
use crate::dynamics::{Load, Problem, Torque};
use crate::numerics::{DoubleDouble, Phase};

/// A constant torque along the principal axis about which a body spins, exactly: the angle is a quadratic of time.
///
/// Where the other two moments are equal, ω across the axis turns in the body by a quadratic of time too; the attitude of
/// that motion has no elementary form, so that it is covered only where nobody wants the attitude.
#[derive(Debug, Clone)]
pub struct AxialTorque {
    motion: Axial,
    translation: Option<Ballistic>,
    wants_attitude: bool,
    last_time: f64,
    evaluations: u64,
}

/// An angle with a constant acceleration, in turns.
#[derive(Debug, Clone, Copy)]
struct Quadratic {
    rate: DoubleDouble,
    half_acceleration: DoubleDouble,
}

impl Quadratic {
    #[inline(always)]
    fn sin_cos(&self, time: f64) -> (f64, f64) {
        let rate = self.rate + self.half_acceleration * time;
        Phase { start: DoubleDouble::ZERO, rate }.at(time).sin_cos()
    }
}

#[derive(Debug, Clone, Copy)]
struct Axial {
    /// The axis, then those after it in turn.
    axes: [usize; 3],
    /// Of these, rad/s.
    omega: [f64; 3],
    /// rad/s².
    acceleration: DoubleDouble,
    half_angle: Quadratic,
    /// By which ω across the axis turns in the body.
    across: Quadratic,
    /// Attitude = this × (cos, sin) of the half-angle.
    attitude_map: QuaternionMap<2>,
}

/// The axis of the torque and its size, if the problem is of this kind.
fn axis(problem: &Problem) -> Option<(usize, f64)> {
    let [Load { torque, window }] = problem.loads.as_slice() else {
        return None;
    };
    let (moment, turns_with_body) = match *torque {
        Torque::ConstantBody { moment } => (moment, true),
        Torque::ConstantWorld { moment } => (along_body_axis(problem.initial.attitude.wxyz(), moment)?, false),
        _ => return None,
    };
    let axis = (0..3).find(|&axis| moment[axis] != 0.0)?;
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let omega = problem.initial.angular_velocity.in_body();
    let moments = problem.moments.vector();
    let is_along = others.iter().all(|&other| moment[other] == 0.0);
    let is_spin = others.iter().all(|&other| omega[other] == 0.0);
    let is_symmetric = turns_with_body && moments[others[0]] == moments[others[1]] && !problem.wants_attitude;
    let is_always = window.start <= 0.0 && window.end == f64::INFINITY;
    (is_always && is_along && (is_spin || is_symmetric)).then(|| (axis, moment[axis]))
}

/// A vector along a world axis in body axes, if a body axis lies exactly along that axis.
fn along_body_axis([w, imaginary @ ..]: [f64; 4], in_world: Vector3<f64>) -> Option<Vector3<f64>> {
    let j = (0..3).find(|&j| in_world[j] != 0.0)?;
    let (next, last) = ((j + 1) % 3, (j + 2) % 3);
    let square = |value: f64| DoubleDouble::product(value, value);
    let [here, there] = [next, last].map(|i| DoubleDouble::product(imaginary[j], imaginary[i]));
    let [by_next, by_last] = [next, last].map(|i| DoubleDouble::product(w, imaginary[i]));
    // The row of R that belongs to the world axis, but for a factor 2 beside the diagonal.
    let mut row = [DoubleDouble::ZERO; 3];
    row[j] = square(w) + square(imaginary[j]) - square(imaginary[next]) - square(imaginary[last]);
    (row[next], row[last]) = (here - by_last, there + by_next);
    let axis = (0..3).find(|&axis| !row[axis].is_zero())?;
    let is_exact = [next, last].iter().all(|&other| in_world[other] == 0.0)
        && (0..3).all(|other| other == axis || row[other].is_zero());
    let mut in_body = Vector3::zeros();
    in_body[axis] = in_world[j].copysign(in_world[j] * row[axis].hi());
    is_exact.then_some(in_body)
}

impl AxialTorque {
    /// Whether one torque along a principal axis, constant in the body or in the world and without a window, is all that
    /// turns a body that spins about that axis; or one constant in a body symmetric about the axis whose attitude is not
    /// asked for. A torque in the world must lie along a world axis and exactly along the body's.
    #[must_use]
    pub fn covers(problem: &Problem) -> bool {
        axis(problem).is_some()
    }

    /// The motion of this problem.
    ///
    /// # Errors
    /// If the problem is of another kind (see [`Self::covers`]).
    pub fn new(problem: &Problem) -> Result<Self, PropagationError> {
        let method = "the closed form of an axial torque";
        let rule = "it needs one constant torque along the principal axis of a steady spin";
        let (axis, moment) = axis(problem).ok_or(PropagationError::NotCovered { method, rule })?;
        Ok(Self {
            motion: Axial::new(problem, axis, moment),
            translation: problem.wants_translation.then(|| Ballistic::new(problem)),
            wants_attitude: problem.wants_attitude,
            last_time: 0.0,
            evaluations: 0,
        })
    }
}

impl Axial {
    fn new(problem: &Problem, axis: usize, moment: f64) -> Self {
        let axes = [axis, (axis + 1) % 3, (axis + 2) % 3];
        let moments = axes.map(|axis| problem.moments.vector()[axis]);
        let omega = axes.map(|axis| problem.initial.angular_velocity.in_body()[axis]);
        let acceleration = DoubleDouble::from(moment) / moments[0].into();
        let (per_turn, spin) = (DoubleDouble::PI.scale(2.0).recip(), DoubleDouble::from(omega[0]));
        let quadratic = |share: DoubleDouble| Quadratic {
            rate: spin * share * per_turn,
            half_acceleration: (acceleration * share * per_turn).scale(0.5),
        };
        let attitude = ExactQuaternion::along(problem.initial.attitude.wxyz());
        let mut about = [DoubleDouble::ZERO; 4];
        about[axis + 1] = DoubleDouble::ONE;
        Self {
            axes,
            omega,
            acceleration,
            half_angle: quadratic(DoubleDouble::ONE.scale(0.5)),
            across: quadratic(DoubleDouble::sum(moments[0], -moments[1]) / moments[1].into()),
            attitude_map: QuaternionMap::new([attitude, attitude.times(ExactQuaternion(about))]),
        }
    }
}

impl Axial {
    /// Whether the angle turned by `time` is small enough for double-double.
    fn angle_is_finite(&self, time: f64) -> bool {
        let fastest = self.omega[0].abs().max(1.0) + self.acceleration.hi().abs() * time;
        fastest * time < FreeRotation::LARGEST_ANGLE
    }
}

impl Rates for Axial {
    fn axes(&self) -> [usize; 3] {
        self.axes
    }

    #[inline(always)]
    fn rates(&self, time: f64) -> [f64; 3] {
        let [spin, w1, w2] = self.omega;
        let (sin, cos) = self.across.sin_cos(time);
        let spin = (self.acceleration * time + spin.into()).hi();
        [spin, w1 * cos - w2 * sin, w2 * cos + w1 * sin]
    }
}

impl Motion for Axial {
    #[inline(always)]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let (sin, cos) = self.half_angle.sin_cos(time);
        (self.rates(time), self.attitude_map.unit([cos, sin]))
    }
}

impl Propagator for AxialTorque {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.last_time)?;
        // Ascending times: if the last angle is a number, all are.
        if times.last().is_some_and(|&time| !self.motion.angle_is_finite(time)) {
            return Err(PropagationError::NotFinite { time: self.last_time });
        }
        self.last_time = times.last().copied().unwrap_or(self.last_time);
        states.reset(times.len(), self.wants_attitude, self.translation.is_some());
        fill_columns(&self.motion, times, self.wants_attitude, states);
        if let Some(translation) = &self.translation {
            translation.fill(times, states);
        }
        self.evaluations += times.len() as u64;
        Ok(())
    }

    fn effort(&self) -> Effort {
        Effort { evaluations: self.evaluations, ..Effort::default() }
    }
}
