use nalgebra::Vector3;

use super::crossing::evenly;
use crate::dynamics::Problem;
use crate::propagation::{FreeRotation, PropagationError, Propagator, States, attitude_distance};
use crate::scenario::PlannedBody;

/// Times at which forces are looked at.
const LOOKS: usize = 1000;

/// The larger of |Σ Fᵢ| / Σ |Fᵢ| and |Σ rᵢ × Fᵢ| / Σ |rᵢ| |Fᵢ|, the largest of a thousand times over `duration`, s, where Fᵢ is
/// what the springs do to particle i and rᵢ is its place from the centre of mass. 0 where no spring pulls.
pub fn net_internal_force(body: &PlannedBody, duration: f64) -> Result<f64, PropagationError> {
    let mut states = States::default();
    body.propagator()?.fill(&evenly(0.0, duration, LOOKS), &mut states)?;
    let mut most = 0.0_f64;
    for row in 0..states.len() {
        let vector = |columns: &[Vec<f64>; 3]| Vector3::from_fn(|axis, _| columns[axis][row]);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        let (mut gross_force, mut gross_moment) = (0.0, 0.0);
        for particle in &states.cloud.particles {
            let (arm, pull) = (vector(&particle.arm), vector(&particle.force));
            force += pull;
            moment += arm.cross(&pull);
            gross_force += pull.norm();
            gross_moment += arm.norm() * pull.norm();
        }
        let part = |net: Vector3<f64>, gross: f64| if net == Vector3::zeros() { 0.0 } else { net.norm() / gross };
        for part in [part(force, gross_force), part(moment, gross_moment)] {
            // A NaN must fail the check, and `max` would hide it.
            most = if part.is_nan() { f64::NAN } else { most.max(part) };
        }
    }
    Ok(most)
}

/// The angle, rad, at `time`, s, between the attitude of the cloud and that of the rigid body of the same start, known in
/// closed form.
pub fn departure_from_rigid(body: &PlannedBody, time: f64) -> Result<f64, PropagationError> {
    let problem = Problem { wants_attitude: true, wants_translation: false, ..body.problem.clone() };
    let (mut cloud, mut rigid) = (States::default(), States::default());
    let body = PlannedBody { problem: problem.clone(), ..body.clone() };
    body.propagator()?.fill(&[time], &mut cloud)?;
    FreeRotation::new(&Problem { loads: Vec::new(), ..problem })?.fill(&[time], &mut rigid)?;
    Ok(attitude_distance(&cloud, &rigid))
}
