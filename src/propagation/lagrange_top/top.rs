use super::homoclinic::Homoclinic;
use super::motion::TopMotion;
use super::nutation::{Nome, Periodic};
use super::roots::Roots;
use super::start::Start;
use super::steady::Steady;
use crate::dynamics::{Load, Problem, Torque};
use crate::numerics::{ShiftedFlips, ShiftedSeries};
use crate::propagation::exact::{ExactQuaternion, Motion, fill_columns};
use crate::propagation::sampling::check_times;
use crate::propagation::{Effort, FreeRotation, PropagationError, Propagator, States};

/// The motion of a symmetric top under a force constant in the world, exactly: any tilt, spin and time. A magnet along
/// the axis of symmetry of a body in a uniform field is one too: the dipole is the arm, the field the force.
///
/// Inputs are taken as exact, the quaternion normalised beyond its last bit. Attitudes are within 2e-15 rad at any time;
/// near an upright axis, where the motion hangs on the last bits of the start, within ten roundings of the inputs. The
/// quaternion starts with the sign it was given and follows the motion without jumps.
#[derive(Debug, Clone)]
pub struct LagrangeTop {
    branch: Branch,
    wants_attitude: bool,
    last_time: f64,
    /// Times beyond it would overflow the phases, s.
    horizon: f64,
    evaluations: u64,
}

/// The forms of the solution, each the limit of its neighbours.
#[derive(Debug, Clone, Copy)]
enum Branch {
    Steady(TopMotion<Steady>),
    Series(TopMotion<Periodic<ShiftedSeries>>),
    Flips(TopMotion<Periodic<ShiftedFlips>>),
    Homoclinic(TopMotion<Homoclinic>),
}

/// A top's force in world axes, the principal axis that carries its arm, and the arm with its sign; N and m, or T and A m².
type Weight = ([f64; 3], usize, f64);

/// The weight of a top, if the problem is one.
fn weight(problem: &Problem) -> Option<Weight> {
    let [
        Load {
            torque: Torque::ForceWorld { force, arm } | Torque::MagneticDipole { dipole: arm, field: force },
            window,
        },
    ] = problem.loads.as_slice()
    else {
        return None;
    };
    if window.start > 0.0 || window.end < f64::INFINITY || problem.wants_translation {
        return None;
    }
    let axis = (0..3).find(|&axis| arm[axis] != 0.0)?;
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let moments = problem.moments.vector();
    let is_along = others.iter().all(|&other| arm[other] == 0.0);
    let is_symmetric = moments[others[0]] == moments[others[1]];
    let acts = force.amax() > 0.0 && force.amax() * arm[axis].abs() > 0.0;
    (is_along && is_symmetric && acts).then(|| ((*force).into(), axis, arm[axis]))
}

impl LagrangeTop {
    /// Whether the problem is a Lagrange top: one force constant in the world, or one dipole in a field, that acts
    /// always, its arm along a principal axis, the two moments about the others equal in every bit, no translation asked for, and no number so
    /// far from the others that constants overflow.
    #[must_use]
    pub fn covers(problem: &Problem) -> bool {
        Self::new(problem).is_ok()
    }

    /// The motion of this problem.
    ///
    /// # Errors
    /// If the problem is no Lagrange top (see [`Self::covers`]), or its numbers are so far apart that the constants
    /// overflow.
    pub fn new(problem: &Problem) -> Result<Self, PropagationError> {
        let refuse = |rule| PropagationError::NotCovered { method: "the closed form of the Lagrange top", rule };
        let (force, axis, arm) = weight(problem).ok_or_else(|| {
            refuse("it needs one force or field constant in the world, its arm or dipole on a principal axis, equal moments about the others")
        })?;
        let attitude = ExactQuaternion::along(problem.initial.attitude.wxyz());
        let omega = problem.initial.angular_velocity.in_body().into();
        let start = Start::new(problem.moments.vector().into(), omega, attitude, force, (axis, arm));
        let branch = Branch::new(&start);
        if !branch.is_finite() {
            return Err(refuse("its moments, force and rates are too far apart"));
        }
        let fastest = problem.initial.angular_velocity.in_body().amax() + start.strength.hi().sqrt();
        let horizon = FreeRotation::LARGEST_ANGLE / fastest.max(1.0);
        Ok(Self { branch, wants_attitude: problem.wants_attitude, last_time: 0.0, horizon, evaluations: 0 })
    }
}

impl Branch {
    fn new(start: &Start) -> Self {
        let Some(roots) = Roots::new(start) else {
            return Self::Steady(TopMotion::new(start, Steady::form(start)));
        };
        if roots.upper_gap.is_zero() {
            return Self::Homoclinic(TopMotion::new(start, Homoclinic::form(start, &roots)));
        }
        match Nome::new(start, &roots) {
            Nome::Series(form) => Self::Series(TopMotion::new(start, form)),
            Nome::Flips(form) => Self::Flips(TopMotion::new(start, form)),
        }
    }

    /// Whether the start itself comes out as numbers.
    fn is_finite(&self) -> bool {
        let (rates, attitude) = match self {
            Self::Steady(motion) => motion.rates_and_attitude(0.0),
            Self::Series(motion) => motion.rates_and_attitude(0.0),
            Self::Flips(motion) => motion.rates_and_attitude(0.0),
            Self::Homoclinic(motion) => motion.rates_and_attitude(0.0),
        };
        rates.iter().chain(&attitude).all(|value| value.is_finite())
    }
}

impl Propagator for LagrangeTop {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.last_time)?;
        if times.last().is_some_and(|&time| time > self.horizon) {
            return Err(PropagationError::NotFinite { time: self.last_time });
        }
        self.last_time = times.last().copied().unwrap_or(self.last_time);
        states.reset(times.len(), self.wants_attitude, false);
        match &self.branch {
            Branch::Steady(motion) => fill_columns(motion, times, self.wants_attitude, states),
            Branch::Series(motion) => fill_columns(motion, times, self.wants_attitude, states),
            Branch::Flips(motion) => fill_columns(motion, times, self.wants_attitude, states),
            Branch::Homoclinic(motion) => fill_columns(motion, times, self.wants_attitude, states),
        }
        self.evaluations += times.len() as u64;
        Ok(())
    }

    fn effort(&self) -> Effort {
        Effort { evaluations: self.evaluations, ..Effort::default() }
    }
}
