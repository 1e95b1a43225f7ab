use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::Scheme;
use crate::body::{AngularVelocity, Attitude, State};
use crate::dynamics::Problem;
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values, state, values_of};

/// The discrete Moser–Veselov equations of a free body, [MV91], with preprocessed moments of inertia, [HV06].
///
/// A step turns the body by the quaternion (p₀, p) with 2 (p₀ Ĩ p + p × Ĩ p) = h L. L stays in the world and the energy
/// stays: the discrete motion lies on the true polhode, and preprocessing mends the time at which it is where.
pub(super) struct MoserVeselov {
    moments: Vector3<f64>,
    preprocessing: Preprocessing,
}

/// Up to which order the moments of inertia are preprocessed.
pub(super) enum Preprocessing {
    /// Not at all: Ĩ = I.
    Order2,
    /// By the terms in h².
    Order4,
}

impl MoserVeselov {
    /// The iteration gains about a factor h |ω| each time.
    const MOST_ITERATIONS: usize = 100;

    pub fn new(problem: &Problem, preprocessing: Preprocessing) -> Self {
        Self { moments: problem.moments.vector(), preprocessing }
    }

    /// Ĩ, of the same energy and momentum: 1/Ĩⱼ = (1 + h² s₃)/Iⱼ + h² d₃ [HV06].
    fn preprocessed(&self, step: f64, momentum: &Vector3<f64>) -> Vector3<f64> {
        match self.preprocessing {
            Preprocessing::Order2 => self.moments,
            Preprocessing::Order4 => {
                let inertia = self.moments;
                let half_square = 0.5 * momentum.norm_squared();
                let energy = 0.5 * momentum.dot(&momentum.component_div(&inertia));
                let product = inertia.product();
                let inverses = inertia.map(|moment| 1.0 / moment);
                let s3 = inertia.sum() / (6.0 * product) * half_square - inverses.sum() / 3.0 * energy;
                let d3 = inertia.sum() / (6.0 * product) * energy - half_square / (3.0 * product);
                let square = step * step;
                inverses.map(|inverse| 1.0 / (inverse * (1.0 + square * s3) + square * d3))
            }
        }
    }
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
        let inertia = self.preprocessed(step, &momentum);
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
    (last_change < 1e-14).then(|| UnitQuaternion::new_unchecked(Quaternion::from_parts(real, p)))
}
