use nalgebra::Vector3;

use super::sampling::check_times;
use super::{Ballistic, Effort, FreeRotation, PropagationError, Propagator, States};
use crate::dynamics::{EulerEquations, Load, Problem, Torque, attitude_rate};
use crate::numerics::DoubleDouble;

/// Free rotation under a brake τ = −c L, exactly: L keeps its direction and dies away as e^(−ct).
///
/// With the time s = (1 − e^(−ct))/c the attitude is the torque-free one, and ω is e^(−ct) times the torque-free one. s
/// is formed in double-double, and what an f64 leaves of it is turned on: attitudes are within 2e-15 rad at any time.
#[derive(Debug, Clone)]
pub struct BrakedRotation {
    free: FreeRotation,
    euler: EulerEquations,
    translation: Option<Ballistic>,
    /// c, 1/s.
    rate: f64,
    last_time: f64,
}

/// The rate of the brake, if it is all that acts and acts always.
fn brake(problem: &Problem) -> Option<f64> {
    match problem.loads.as_slice() {
        [Load { torque: Torque::MomentumBrake { rate }, window }] => {
            (window.start <= 0.0 && window.end == f64::INFINITY).then_some(*rate)
        }
        _ => None,
    }
}

impl BrakedRotation {
    /// Whether one brake along L, without a window, is all that turns the body, and [`FreeRotation`] covers the rest.
    #[must_use]
    pub fn covers(problem: &Problem) -> bool {
        Self::new(problem).is_ok()
    }

    /// The motion of this problem.
    ///
    /// # Errors
    /// If anything else turns the body, or its moments are too far apart for [`FreeRotation`].
    pub fn new(problem: &Problem) -> Result<Self, PropagationError> {
        let rule = "one brake along L that acts always must be all that turns the body";
        let method = "the closed form under a brake";
        let rate = brake(problem).ok_or(PropagationError::NotCovered { method, rule })?;
        let unbraked = Problem { loads: Vec::new(), wants_translation: false, ..problem.clone() };
        Ok(Self {
            free: FreeRotation::new(&unbraked)?,
            euler: EulerEquations::new(problem.moments),
            translation: problem.wants_translation.then(|| Ballistic::new(problem)),
            rate,
            last_time: 0.0,
        })
    }

    /// s = (1 − e^(−ct))/c.
    fn slowed(&self, time: f64) -> DoubleDouble {
        let decay = DoubleDouble::product(self.rate, time);
        if decay.hi() < 1e-290 {
            return time.into();
        }
        // 1 − e^(−x) = 2 e^(−x/2) sinh(x/2), which cancels nowhere; beyond 80 it is 1 in 106 bits.
        let spent = if decay.hi() > 80.0 {
            DoubleDouble::ONE
        } else {
            let half = decay.scale(0.5);
            ((-half).exp() * half.sinh_cosh().0).scale(2.0)
        };
        spent / self.rate.into()
    }
}

impl Propagator for BrakedRotation {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.last_time)?;
        self.last_time = times.last().copied().unwrap_or(self.last_time);
        let slowed: Vec<_> = times.iter().map(|&time| self.slowed(time)).collect();
        let nearest: Vec<_> = slowed.iter().map(|time| time.hi()).collect();
        self.free.fill(&nearest, states)?;
        for (row, (&time, slowed)) in times.iter().zip(&slowed).enumerate() {
            let left = (-DoubleDouble::product(self.rate, time)).exp().hi();
            self.turn_on(states, row, slowed.lo(), left);
        }
        if let Some(translation) = &self.translation {
            states.position.iter_mut().chain(&mut states.velocity).for_each(|column| column.resize(times.len(), 0.0));
            translation.fill(times, states);
        }
        Ok(())
    }

    fn effort(&self) -> Effort {
        self.free.effort()
    }
}

impl BrakedRotation {
    /// From s to s + `rest`, a rounding of s, to first order, which is exact; then ω times what the brake has `left`.
    fn turn_on(&self, states: &mut States, row: usize, rest: f64, left: f64) {
        let omega = Vector3::from(states.angular_velocity.each_ref().map(|column| column[row]));
        let slower = left * (omega + rest * self.euler.acceleration(&omega, &Vector3::zeros()));
        for (axis, column) in states.angular_velocity.iter_mut().enumerate() {
            column[row] = slower[axis];
        }
        if !states.attitude[0].is_empty() {
            let rate = attitude_rate(states.attitude.each_ref().map(|column| column[row]), &omega);
            for (column, rate) in states.attitude.iter_mut().zip(rate) {
                column[row] += rest * rate;
            }
        }
    }
}
