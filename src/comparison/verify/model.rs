use nalgebra::{UnitQuaternion, Vector3};

use super::series::Series;
use super::subject::{Subject, state};
use crate::numerics::so3;

/// A wrong law of motion.
#[derive(Debug, Clone, Copy)]
pub(super) enum Model {
    /// I ω̇ = τ.
    NoGyroscopicTerm,
    /// Euler's equations in world axes, with a tensor that does not turn.
    InertiaInWorld {
        /// The turn at which it is held.
        world_from_principal: UnitQuaternion<f64>,
        /// Whether with ω × I ω.
        gyroscopic: bool,
    },
}

/// Longest step, as a turn in rad: RK4 is then right to 1e-10, and wrong laws are wrong by far more.
const STEP: f64 = 0.02;
/// Steps at most, for samples many turns apart.
const MOST_STEPS: f64 = 2000.0;

/// ω in principal axes where a wrong law leads from sample `k` to the time of the next.
pub(super) fn carried_by(model: Model, subject: &Subject, series: &Series, k: usize) -> Vector3<f64> {
    let duration = series.times[k + 1] - series.times[k];
    if matches!(model, Model::NoGyroscopicTerm) && subject.is_free() {
        return subject.omega[k];
    }
    let count = (series.rate() * duration / STEP).ceil().clamp(1.0, MOST_STEPS);
    let h = duration / count;
    let (mut q, mut omega, mut time) =
        (subject.attitude.get(k).copied().unwrap_or_default(), subject.omega[k], series.times[k]);
    let mut steps = count;
    while steps > 0.0 {
        let rate = |turn: Vector3<f64>, omega: Vector3<f64>, time: f64| {
            acceleration(model, subject, q * so3::exp(&turn), omega, time)
        };
        // Turns within a step by the trapezium: good enough for where a torque points.
        let k1 = rate(Vector3::zeros(), omega, time);
        let k2 = rate(0.5 * h * omega, omega + 0.5 * h * k1, time + 0.5 * h);
        let k3 = rate(0.5 * h * (omega + 0.25 * h * k1), omega + 0.5 * h * k2, time + 0.5 * h);
        let k4 = rate(h * (omega + 0.5 * h * k2), omega + h * k3, time + h);
        let after = omega + (h / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        let middle = omega + 0.25 * h * (k1 + k2);
        q *= so3::exp(&((h / 6.0) * (omega + 4.0 * middle + after)));
        omega = after;
        time += h;
        steps -= 1.0;
    }
    omega
}

/// ω̇ in principal axes.
fn acceleration(
    model: Model,
    subject: &Subject,
    q: UnitQuaternion<f64>,
    omega: Vector3<f64>,
    time: f64,
) -> Vector3<f64> {
    let problem = subject.problem();
    let moments = problem.moments.vector();
    let torque = subject.moment(time, &state(q, omega));
    match model {
        Model::NoGyroscopicTerm => torque.component_div(&moments),
        Model::InertiaInWorld { world_from_principal, gyroscopic } => {
            // In the axes in which the tensor is held; what a body axis sees of a world vector's change is the same.
            let held_from_body = world_from_principal.inverse() * q;
            let (rate, torque) = (held_from_body * omega, held_from_body * torque);
            let term = if gyroscopic { rate.cross(&moments.component_mul(&rate)) } else { Vector3::zeros() };
            held_from_body.inverse() * (torque - term).component_div(&moments)
        }
    }
}
