use nalgebra::Vector3;

use super::kinematics::Estimate;
use super::pushed::WIDTH;
use super::series::{Series, count_of, rms};
use super::subject::Subject;
use crate::body::State;
use crate::dynamics::{momentum_in_world, rotational_energy};
use crate::propagation::PropagationError;

/// Do ω, L and E change from sample to sample as the torques make them?
///
/// Each sample is carried exactly to the next one's time and compared with it: what is left is the program's own error
/// in that interval, however far apart samples are.
#[derive(Debug, Clone, PartialEq)]
pub struct Laws {
    /// Root mean square of the error of ω within an interval, relative to ω.
    pub defect: f64,
    /// What rounding in the file leaves of that in doubt.
    pub floor: f64,
    /// E gained in a turn that no torque gives, relative.
    pub energy_per_turn: Estimate,
    /// |L| gained in a turn that no torque gives, relative.
    pub momentum_per_turn: Estimate,
    /// By how much L turns about in the world that no torque turns it, rad over the whole; `None` without attitudes.
    pub direction_rad: Option<Estimate>,
    /// Turns of the body over the whole.
    pub turns: f64,
}

/// The intervals looked at, and where exact motion leads in each.
pub(super) struct Steps {
    /// Each from sample k to k + 1.
    pub intervals: Vec<usize>,
    /// Of all intervals.
    pub share: f64,
    /// At the end of each.
    pub exact: Vec<State>,
    /// ω recorded there less the exact one, principal axes, rad/s.
    pub defects: Vec<Vector3<f64>>,
    /// What rounding leaves in doubt of each, rad/s.
    pub floors: Vec<f64>,
}

/// Intervals at most: the errors of so many tell those of the rest.
pub(super) const MOST_INTERVALS: usize = 20_000;

impl Steps {
    /// Of `most` intervals, in neighbouring pairs spread over all: noise is told by what it does to both.
    pub fn of(subject: &Subject, series: &Series, rounding_s: f64, most: usize) -> Result<Self, PropagationError> {
        let count = series.len().saturating_sub(1);
        let stride = count.div_ceil(most).max(1);
        let intervals: Vec<usize> = (0..count).filter(|k| (k / 2).is_multiple_of(stride)).collect();
        let mut exact = Vec::with_capacity(intervals.len());
        let (mut defects, mut floors) = (Vec::new(), Vec::new());
        let rate = series.rate();
        for &k in &intervals {
            let duration = series.times[k + 1] - series.times[k];
            let state = subject.carried(subject.state(k), series.times[k], duration)?;
            let omega = subject.omega[k + 1];
            defects.push(omega - state.angular_velocity.in_body());
            // An error of ω grows within an interval no faster than rates do: by |ω| each second.
            let growth = 1.0 + (rate * duration).min(20.0);
            let turning = subject.attitude.get(k).map_or(0.0, |_| series.attitude_doubt) * change(subject, k, duration);
            let times = rounding_s + f64::EPSILON * series.times[k + 1].abs();
            floors.push(
                unknown_push(subject, series, k) * duration
                    + 2.0 * series.omega_doubt * growth
                    + turning
                    + times * rate * rate
                    + ROUNDINGS * f64::EPSILON * rate * growth,
            );
            exact.push(state);
        }
        let share = count_of(intervals.len()) / count_of(count.max(1));
        Ok(Self { intervals, share, exact, defects, floors })
    }

    pub fn defect(&self) -> f64 {
        rms(self.defects.iter().map(Vector3::norm))
    }

    pub fn floor(&self) -> f64 {
        rms(self.floors.iter().copied())
    }
}

/// Of the exact motion over an interval.
const ROUNDINGS: f64 = 8.0;

/// What of ω̇ a recorded moment leaves in doubt between its samples, rad/s².
fn unknown_push(subject: &Subject, series: &Series, k: usize) -> f64 {
    let Some(pushed) = &subject.pushed else { return 0.0 };
    let (state, middle) = (subject.state(k), 0.5 * (series.times[k] + series.times[k + 1]));
    let lost = pushed.at(middle, &state, WIDTH) - pushed.at(middle, &state, 2);
    lost.component_div(&subject.problem().moments.vector()).norm() + PUSHED * subject.omega[k].norm()
}

/// Of the steps under a recorded moment, 1/s.
const PUSHED: f64 = 1e-11;

/// How much ω changes under the torques in an interval, at most: what of it an attitude in doubt may change.
fn change(subject: &Subject, k: usize, duration: f64) -> f64 {
    duration * subject.moment(0.0, &subject.state(k)).component_div(&subject.problem().moments.vector()).norm()
}

impl Laws {
    pub(super) fn of(subject: &Subject, series: &Series, steps: &Steps) -> Self {
        let moments = subject.problem().moments;
        let rate = series.rate().max(f64::MIN_POSITIVE);
        let turns = (series.angle() / std::f64::consts::TAU).max(f64::MIN_POSITIVE);
        let (mut energy, mut momentum) = (0.0, 0.0);
        let mut along = Vector3::zeros();
        for (index, &k) in steps.intervals.iter().enumerate() {
            let exact = &steps.exact[index];
            let (due, found) = (momentum_in_world(moments, exact), subject.momentum(k + 1));
            energy += subject.energy(k + 1) - rotational_energy(moments, exact);
            momentum += found.norm() - due.norm();
            if let Some(direction) = found.try_normalize(0.0) {
                let off = (found - due) / found.norm();
                along += off - direction * off.dot(&direction);
            }
        }
        let mean_energy = (0..series.len()).map(|k| subject.energy(k)).sum::<f64>() / count_of(series.len());
        let mean_momentum = (0..series.len()).map(|k| subject.momentum(k).norm()).sum::<f64>() / count_of(series.len());
        // Rounding comes in at both ends of every interval but adds up like a random walk.
        let walk = count_of(steps.intervals.len()).sqrt() / steps.share;
        let doubt = steps.floor() / rate * walk;
        let per_turn = |sum: f64, mean: f64, weight: f64| Estimate {
            value: sum / steps.share / mean.max(f64::MIN_POSITIVE) / turns,
            doubt: weight * doubt / turns,
        };
        let turned = Estimate { value: along.norm() / steps.share, doubt: doubt + series.attitude_doubt * walk };
        Self {
            defect: steps.defect() / rate,
            floor: steps.floor() / rate,
            energy_per_turn: per_turn(energy, mean_energy, 2.0),
            momentum_per_turn: per_turn(momentum, mean_momentum, 1.0),
            direction_rad: (!series.attitude.is_empty()).then_some(turned),
            turns,
        }
    }
}
