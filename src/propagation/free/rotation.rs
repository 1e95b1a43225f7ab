use super::invariants::{Polhode, Start};
use super::polhode_rates::{PolhodeRates, RatesNome};
use super::reversals::Reversals;
use super::separatrix::Separatrix;
use super::symmetric::Symmetric;
use super::tri_axial::{Nome, TriAxial};
use super::uniform::Uniform;
use crate::dynamics::Problem;
use crate::numerics::{FlipSum, JacobiFlips, JacobiSeries, NomeSeries};
use crate::propagation::ballistic::Ballistic;
use crate::propagation::exact::ExactQuaternion;
use crate::propagation::exact::Frame;
use crate::propagation::exact::{fill_columns, fill_rates};
use crate::propagation::{Effort, PropagationError, Propagator, States};

/// The torque-free motion, exactly: any principal moments, any ω, any time, at the cost of one evaluation a sample.
///
/// Inputs are taken as exact, the quaternion normalised beyond its last bit. Attitudes are then within 1e-15 rad and ω
/// within 1e-15 of its size, at any time and however near the separatrix. The quaternion starts with the sign it was given
/// and follows the motion without jumps.
#[derive(Debug, Clone)]
pub struct FreeRotation {
    branch: Branch,
    translation: Option<Ballistic>,
    wants_attitude: bool,
    last_time: f64,
    /// Times beyond it would overflow the phases, s.
    horizon: f64,
    evaluations: u64,
}

/// The forms of the solution, each the limit of its neighbours.
#[derive(Debug, Clone, Copy)]
enum Branch {
    Uniform(Uniform),
    Symmetric(Symmetric),
    Series(TriAxial<NomeSeries>),
    Flips(TriAxial<FlipSum>),
    /// Without attitude.
    SeriesRates(PolhodeRates<JacobiSeries>),
    /// Without attitude.
    FlipsRates(PolhodeRates<JacobiFlips>),
    Separatrix(Separatrix),
}

impl FreeRotation {
    /// Smallest ratio of two moments for which no exponent over- or underflows.
    pub const MOMENT_RATIO: f64 = 1e-24;

    /// A component of ω below this fraction of the largest counts as zero: its square times a moment would underflow.
    pub const NEGLIGIBLE: f64 = 1e-120;

    /// Times, and angles turned since t = 0 in rad, beyond this are refused as not finite.
    pub const LARGEST_ANGLE: f64 = 1e280;

    /// The motion of this problem.
    ///
    /// # Errors
    /// If something acts on the body, or the moments differ by more than [`Self::MOMENT_RATIO`].
    pub fn new(problem: &Problem) -> Result<Self, PropagationError> {
        let refuse = |rule| Err(PropagationError::NotCovered { method: "the torque-free closed form", rule });
        if !problem.loads.is_empty() {
            return refuse("nothing may act on the body");
        }
        let moments: [f64; 3] = problem.moments.vector().into();
        let largest = moments.into_iter().fold(0.0, f64::max);
        if moments.into_iter().any(|moment| moment < Self::MOMENT_RATIO * largest) {
            return refuse("the smallest principal moment must be at least 1e-24 of the largest");
        }
        let attitude = ExactQuaternion::along(problem.initial.attitude.wxyz());
        Ok(Self {
            branch: Branch::new(
                moments,
                problem.initial.angular_velocity.in_body().into(),
                attitude,
                problem.wants_attitude,
            ),
            translation: problem.wants_translation.then(|| Ballistic::new(problem)),
            wants_attitude: problem.wants_attitude,
            last_time: 0.0,
            horizon: Self::LARGEST_ANGLE / problem.initial.angular_velocity.in_body().amax().max(1.0),
            evaluations: 0,
        })
    }

    /// When ω along the middle axis changes sign; `None` where it never does.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn reversals(problem: &Problem) -> Result<Option<Reversals>, PropagationError> {
        Self::new(problem)?;
        let omega = problem.initial.angular_velocity.in_body();
        let (moments, omega, scale) = near_one(problem.moments.vector().into(), omega.into());
        let ascending = ascending(&moments);
        let is_tri_axial = ascending.windows(2).all(|pair| moments[pair[0]] < moments[pair[1]]);
        if !is_tri_axial || turns_uniformly(&omega) {
            return Ok(None);
        }
        let attitude = ExactQuaternion::along(problem.initial.attitude.wxyz());
        let (start, polhode) = tri_axial(ascending, moments, omega, attitude);
        Ok(Some(Reversals::new(&start, &polhode, scale)))
    }
}

/// Moments and ω multiplied by powers of two that bring them near 1, and that of ω.
fn near_one(moments: [f64; 3], omega: [f64; 3]) -> ([f64; 3], [f64; 3], f64) {
    let scale = scale_of(omega.into_iter().fold(0.0, |size, component| size.max(component.abs())));
    let kilograms = scale_of(moments.into_iter().fold(0.0, f64::max));
    let omega = omega.map(|component| {
        let scaled = component * scale;
        if scaled.abs() < FreeRotation::NEGLIGIBLE { 0.0 } else { scaled }
    });
    (moments.map(|moment| moment * kilograms), omega, scale)
}

/// Whether ω stays along one axis.
fn turns_uniformly(omega: &[f64; 3]) -> bool {
    omega.iter().filter(|&&component| component != 0.0).count() < 2
}

/// The axes in the order of their moments.
fn ascending(moments: &[f64; 3]) -> [usize; 3] {
    let mut ascending = [0, 1, 2];
    ascending.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    ascending
}

/// Of three different moments: primed axes such that L circles about the third, and the curve.
fn tri_axial(
    [low, middle, high]: [usize; 3],
    moments: [f64; 3],
    omega: [f64; 3],
    attitude: ExactQuaternion,
) -> (Start, Polhode) {
    let start = |axes| Start::new(Frame::new(axes, omega), moments, omega, attitude);
    let about_high = start([low, middle, high]);
    let separation = about_high.share(2, 1) + about_high.share(0, 1);
    let start = if separation.hi() >= 0.0 { about_high } else { start([high, middle, low]) };
    (start, Polhode::new(&start, separation))
}

/// A power of two that brings `size` near 1: multiplying by it is exact.
fn scale_of(size: f64) -> f64 {
    let exponent = if size > 0.0 { libm::ilogb(size) } else { 0 };
    libm::ldexp(1.0, -exponent.clamp(-1000, 1000))
}

impl Branch {
    fn new(moments: [f64; 3], omega: [f64; 3], attitude: ExactQuaternion, wants_attitude: bool) -> Self {
        let as_given = omega;
        let (moments, omega, scale) = near_one(moments, omega);
        let uniform = || Self::Uniform(Uniform::new(as_given, scale, attitude));
        if turns_uniformly(&omega) {
            return uniform();
        }
        let ascending @ [low, middle, high] = ascending(&moments);
        let start = |axes| Start::new(Frame::new(axes, omega), moments, omega, attitude);
        match (moments[low] == moments[middle], moments[middle] == moments[high]) {
            (true, true) => return uniform(),
            (true, false) => return Self::Symmetric(Symmetric::new(&start([low, middle, high]), scale)),
            (false, true) => return Self::Symmetric(Symmetric::new(&start([middle, high, low]), scale)),
            (false, false) => {}
        }
        let (start, polhode) = tri_axial(ascending, moments, omega, attitude);
        if polhode.complement.is_zero() {
            return Self::Separatrix(Separatrix::new(&start, &polhode, scale));
        }
        if !wants_attitude {
            return match RatesNome::new(&start, &polhode, scale) {
                RatesNome::Series(motion) => Self::SeriesRates(motion),
                RatesNome::Flips(motion) => Self::FlipsRates(motion),
            };
        }
        match Nome::new(&start, &polhode, scale) {
            Nome::Series(motion) => Self::Series(motion),
            Nome::Flips(motion) => Self::Flips(motion),
        }
    }
}

impl Propagator for FreeRotation {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        for &time in times {
            if time.is_nan() || time.abs() > self.horizon {
                return Err(PropagationError::NotFinite { time: self.last_time });
            }
            if time < self.last_time {
                return Err(PropagationError::NotAscending { time, previous: self.last_time });
            }
            self.last_time = time;
        }
        states.reset(times.len(), self.wants_attitude, self.translation.is_some());
        match &self.branch {
            Branch::Uniform(motion) => fill_columns(motion, times, self.wants_attitude, states),
            Branch::Symmetric(motion) => fill_columns(motion, times, self.wants_attitude, states),
            Branch::Series(motion) => fill_columns(motion, times, self.wants_attitude, states),
            Branch::Flips(motion) => fill_columns(motion, times, self.wants_attitude, states),
            Branch::SeriesRates(motion) => fill_rates(motion, times, states),
            Branch::FlipsRates(motion) => fill_rates(motion, times, states),
            Branch::Separatrix(motion) => fill_columns(motion, times, self.wants_attitude, states),
        }
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
