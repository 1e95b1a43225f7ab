use super::laws::{Drift, Laws};
use super::truth::Truth;
use crate::propagation::{Effort, Propagator, States, attitude_distance};
use crate::scenario::{Path, PlannedBody};

/// One run of one method at one setting, held against the truth.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// Tolerance (rad) or step (s) that the method was told, if any.
    pub value: Option<f64>,
    /// By which path.
    pub path: Path,
    /// How it ended.
    pub ending: Ending,
    /// Largest angle from the true attitude, rad, as far as it ran and as the truth is known; infinite if it ran nowhere.
    pub error_rad: f64,
    /// Errors below this are not resolved, rad: the reference is in doubt by as much.
    pub doubt_rad: f64,
    /// Largest difference in ω, relative to the largest ω.
    pub rates_error: f64,
    /// What it may be off if it is at full accuracy, rad: [`Truth::limit_rad`]; or what was asked of the whole run.
    pub limit_rad: f64,
    /// The first of the times at which it was off by more than [`Trial::LOST_RAD`], or after which it failed, s.
    pub lost_at_s: Option<f64>,
    /// Of the energy, if one is conserved.
    pub energy: Option<Drift>,
    /// Of the angular momentum, if it follows a law.
    pub momentum: Option<Drift>,
    /// Largest difference of a quaternion's length from 1.
    pub norm_error: f64,
    /// Largest component of `RᵀR − 1`.
    pub orthogonality_error: f64,
    /// How often the quaternion's sign jumped between times less than a quarter of a turn apart; `None` where they are
    /// farther apart.
    pub sign_jumps: Option<u64>,
    /// Evaluations, steps, rejections, the shortest step.
    pub effort: Effort,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ending {
    /// At the last time.
    Done,
    /// With an error, in words.
    Failed(String),
    /// With a state that is not finite, and no error: never right.
    Silent,
    /// After more steps than were allowed.
    TooLong,
}

impl Trial {
    /// An error of more than this is no longer the same motion, rad.
    pub const LOST_RAD: f64 = 0.1;
    /// What a quaternion's length may differ from 1.
    pub const NORM: f64 = 1e-15;

    /// Runs `body` past every `stride`-th of the times of `truth`, for `most_steps` at most, counted at those times.
    #[must_use]
    pub fn run(body: &PlannedBody, value: Option<f64>, truth: &Truth, (stride, most_steps): (usize, u64)) -> Self {
        let mut trial = Self {
            value,
            path: body.path,
            ending: Ending::Done,
            error_rad: f64::INFINITY,
            doubt_rad: truth.reference.doubt_rad,
            rates_error: f64::INFINITY,
            limit_rad: truth.limit_rad(body.path, 0),
            lost_at_s: Some(0.0),
            energy: None,
            momentum: None,
            norm_error: 0.0,
            orthogonality_error: 0.0,
            sign_jumps: None,
            effort: Effort::default(),
        };
        match body.propagator() {
            Ok(propagator) => trial.follow(body, propagator, truth, (stride, most_steps)),
            Err(error) => trial.ending = Ending::Failed(error.to_string()),
        }
        trial
    }

    fn follow(
        &mut self,
        body: &PlannedBody,
        mut propagator: Box<dyn Propagator>,
        truth: &Truth,
        (stride, most_steps): (usize, u64),
    ) {
        let mut laws = Laws::new(&body.problem);
        let (mut states, mut before) = (States::default(), 0.0);
        self.lost_at_s = None;
        for (row, time) in truth.times_s.iter().enumerate().step_by(stride) {
            self.ending = match propagator.fill(&[*time], &mut states) {
                Ok(()) if !is_finite(&states) => Ending::Silent,
                Ok(()) if propagator.effort().steps > most_steps => Ending::TooLong,
                Ok(()) => Ending::Done,
                Err(error) => Ending::Failed(error.to_string()),
            };
            self.effort = propagator.effort();
            if self.ending != Ending::Done {
                self.lost_at_s = self.lost_at_s.or(Some(before));
                break;
            }
            if row < truth.reference.states.len() {
                self.compare(truth, row, &states);
                self.limit_rad = truth.limit_rad(self.path, self.effort.steps);
            }
            laws.include(*time, &states, 0, self.lost_at_s.is_none());
            before = *time;
        }
        (self.energy, self.momentum) = (laws.energy(), laws.momentum());
        (self.norm_error, self.orthogonality_error) = (laws.norm, laws.orthogonality);
        let apart = truth.times_s.windows(stride + 1).map(|times| times[stride] - times[0]).fold(0.0, f64::max);
        self.sign_jumps = (apart * truth.fastest < std::f64::consts::FRAC_PI_2).then_some(laws.sign_jumps);
    }

    fn compare(&mut self, truth: &Truth, row: usize, states: &States) {
        let exact = one(&truth.reference.states, row);
        let error = attitude_distance(&exact, states);
        let off = |k: usize| states.angular_velocity[k][0] - exact.angular_velocity[k][0];
        let off = libm::hypot(libm::hypot(off(0), off(1)), off(2));
        let relative = if off > 0.0 { off / truth.fastest } else { 0.0 };
        let so_far = |value: f64| if row == 0 { 0.0 } else { value };
        self.error_rad = so_far(self.error_rad).max(error);
        self.rates_error = so_far(self.rates_error).max(relative);
        if error > Self::LOST_RAD {
            self.lost_at_s = self.lost_at_s.or(Some(truth.times_s[row]));
        }
    }

    /// Whether it ran to its end and followed the motion.
    #[must_use]
    pub fn follows(&self) -> bool {
        self.ending == Ending::Done && self.error_rad <= Self::LOST_RAD
    }

    /// Whether what it gave is sound as far as it goes: finite, or an error; of unit length; without jumps.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.ending != Ending::Silent && self.norm_error <= Self::NORM && self.sign_jumps.unwrap_or(0) == 0
    }
}

fn is_finite(states: &States) -> bool {
    let columns = states.attitude.iter().chain(&states.angular_velocity);
    columns.flatten().all(|value| value.is_finite())
}

/// Attitude and ω of one row.
fn one(states: &States, row: usize) -> States {
    States {
        attitude: states.attitude.each_ref().map(|column| vec![column[row]]),
        angular_velocity: states.angular_velocity.each_ref().map(|column| vec![column[row]]),
        ..States::default()
    }
}
