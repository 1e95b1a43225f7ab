use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::Scheme;
use super::preprocessing::{Correction, Term};
use crate::body::{AngularVelocity, Attitude, State};
use crate::dynamics::Problem;
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values, state, values_of};

/// The discrete Moser–Veselov equations of a free body, `[MV91]`, with preprocessed moments of inertia, `[HV06]`.
///
/// A step turns the body by the quaternion (p₀, p) with 2 (p₀ Ĩ p + p × Ĩ p) = h L. L stays in the world and the energy
/// stays: the discrete motion lies on the true polhode, and preprocessing mends the time at which it is where.
pub(super) struct MoserVeselov {
    /// Divided by a power of two, so that the largest is about 1: the motion is the same to the bit, and their powers in the
    /// corrections are numbers whatever their size.
    moments: Vector3<f64>,
    corrections: &'static [Correction],
    /// h and its Ĩ: energy and momentum stay, so Ĩ does for as long as h does.
    preprocessed: Option<(f64, Vector3<f64>)>,
}

impl MoserVeselov {
    /// The iteration gains about a factor h |ω| each time.
    const MOST_ITERATIONS: usize = 100;
    /// A change of p of this size that shrinks no more is rounding.
    const ROUNDING: f64 = 1e-14;

    /// Each correction raises the order by two.
    pub fn new(problem: &Problem, corrections: &'static [Correction]) -> Self {
        let moments = problem.moments.vector();
        let exponent = if moments.max() > 0.0 { libm::ilogb(moments.max()) } else { 0 };
        let moments = moments.map(|moment| libm::scalbn(moment, -exponent));
        Self { moments, corrections, preprocessed: None }
    }

    /// Ĩ: 1/Ĩⱼ = (1 + h² s₃ + …)/Iⱼ + h² d₃ + ….
    fn preprocess(&self, step: f64, momentum: &Vector3<f64>) -> Vector3<f64> {
        let inverses = self.moments.map(|moment| 1.0 / moment);
        let quantities = [
            0.5 * momentum.dot(&momentum.component_mul(&inverses)),
            0.5 * momentum.norm_squared(),
            inverses.sum(),
            inverses.x * inverses.y + inverses.y * inverses.z + inverses.z * inverses.x,
            inverses.product(),
        ];
        let (mut factor, mut shift, mut power) = (1.0, 0.0, 1.0);
        for correction in self.corrections {
            power *= step * step;
            factor += power * sum(correction.factor, &quantities);
            shift += power * sum(correction.shift, &quantities);
        }
        inverses.map(|inverse| 1.0 / (factor * inverse + shift))
    }
}

/// The value of a polynomial.
fn sum(terms: &[Term], quantities: &[f64; 5]) -> f64 {
    let value = |(numerator, denominator, powers): &Term| {
        let factors = quantities.iter().zip(powers).flat_map(|(quantity, power)| std::iter::repeat_n(quantity, *power));
        numerator / denominator * factors.product::<f64>()
    };
    terms.iter().map(value).sum()
}

impl Scheme for MoserVeselov {
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError> {
        let push = equations.push(time, values);
        let State { attitude, angular_velocity, position, velocity } = state(values);
        let momentum = angular_velocity.in_body().component_mul(&self.moments);
        let inertia = match self.preprocessed {
            Some((same, inertia)) if same == step => inertia,
            _ => self.preprocess(step, &momentum),
        };
        self.preprocessed = Some((step, inertia));
        let turn = turn(&inertia, &(0.5 * step * momentum)).ok_or(PropagationError::NoConvergence { time, step })?;
        let momentum = turn.inverse_transform_vector(&momentum);
        let attitude = UnitQuaternion::new_normalize((attitude.world_from_body() * turn).into_inner());
        Ok(values_of(&State {
            attitude: Attitude::from_world_from_body(attitude),
            angular_velocity: AngularVelocity::from_vector(momentum.component_div(&self.moments)),
            position: position + step * (velocity + 0.5 * step * push.acceleration),
            velocity: velocity + step * push.acceleration,
        }))
    }
}

/// The unit quaternion (p₀, p) with p₀ I p + p × I p = `half`, by fixed-point iteration.
fn turn(inertia: &Vector3<f64>, half: &Vector3<f64>) -> Option<UnitQuaternion<f64>> {
    let mut p = half.component_div(inertia);
    let mut last_change = f64::INFINITY;
    for _ in 0..MoserVeselov::MOST_ITERATIONS {
        let real = (1.0 - p.norm_squared()).sqrt();
        let next = (half - p.cross(&p.component_mul(inertia))).component_div(inertia) / real;
        let change = (next - p).amax();
        p = next;
        if change.is_nan() {
            // p has left the unit sphere: no rotation is as large as that.
            return None;
        }
        if change >= last_change {
            break;
        }
        last_change = change;
    }
    let real = (1.0 - p.norm_squared()).sqrt();
    (last_change < MoserVeselov::ROUNDING).then(|| UnitQuaternion::new_unchecked(Quaternion::from_parts(real, p)))
}
