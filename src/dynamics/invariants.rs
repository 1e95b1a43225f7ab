use nalgebra::Vector3;

use super::{Torque, torque::radial_direction};
use crate::body::{PrincipalMoments, State};

/// ½ ω·Iω, J: of the rotation about the reference point (about a pivot: all of the motion's).
#[must_use]
pub fn rotational_energy(moments: PrincipalMoments, state: &State) -> f64 {
    let omega = state.angular_velocity.in_body();
    0.5 * moments.vector().dot(&omega.component_mul(&omega))
}

/// ½ m v², J.
#[must_use]
pub fn translational_energy(mass: f64, state: &State) -> f64 {
    0.5 * mass * state.velocity.norm_squared()
}

/// R I ω, N m s: about the reference point, in world axes. Of the body alone: rotors have momentum of their own,
/// [`Problem::momentum_in_world`](super::Problem::momentum_in_world).
#[must_use]
pub fn momentum_in_world(moments: PrincipalMoments, state: &State) -> Vector3<f64> {
    state.angular_velocity.momentum(moments).in_world(state.attitude)
}

/// The potential energy, J, of a load that has one while it acts; `None` for one that has not (thruster, brake, motor).
///
/// A force constant in the world: −F·(x + R arm). A dipole in a field: −m·Rᵀ B. The gravity gradient: 3/2 n² r·I r.
#[must_use]
pub fn potential_energy(torque: &Torque, moments: PrincipalMoments, time: f64, state: &State) -> Option<f64> {
    match *torque {
        Torque::ForceWorld { force, arm } => Some(-force.dot(&(state.position + state.attitude.to_world(&arm)))),
        Torque::MagneticDipole { dipole, field } => Some(-dipole.dot(&state.attitude.to_body(&field))),
        Torque::GravityGradient { mean_motion } => {
            let radial = state.attitude.to_body(&radial_direction(mean_motion, time));
            Some(1.5 * mean_motion * mean_motion * moments.vector().dot(&radial.component_mul(&radial)))
        }
        Torque::General(ref load) => load.kind.potential_energy(state),
        _ => None,
    }
}

/// ½ ω·Iω + 3/2 n² r·I r − n `L_z`, J: what a body on a circular orbit keeps, its energy as seen from the turning frame.
///
/// As ½ Ω·IΩ + 3/2 n² r·I r − ½ n² z·I z with Ω = ω − n z the rate seen from the orbit and z its normal in the body, which
/// is the same `[Hughes86]`: of a body that follows the orbit, Ω is small, and no large terms cancel.
#[must_use]
pub fn jacobi_integral(mean_motion: f64, moments: PrincipalMoments, time: f64, state: &State) -> f64 {
    let normal = state.attitude.to_body(&Vector3::z());
    let radial = state.attitude.to_body(&radial_direction(mean_motion, time));
    let relative = state.angular_velocity.in_body() - mean_motion * normal;
    let inertia = |v: &Vector3<f64>| moments.vector().dot(&v.component_mul(v));
    0.5 * inertia(&relative) + mean_motion * mean_motion * (1.5 * inertia(&radial) - 0.5 * inertia(&normal))
}
