use nalgebra::Vector3;

use super::Channel;
use super::batch::Batch;
use crate::dynamics::Problem;

/// What a channel reads of the particle of this number, of a cloud on springs: `force_world` is what the springs do to it, and
/// its acceleration is made of that and of gravity.
pub(super) fn read(problem: &Problem, number: usize, channel: Channel, batch: &Batch<'_>, columns: &mut [Vec<f64>]) {
    let Some(particle) = batch.states.cloud.particles.get(number) else { return };
    let mass = problem.cloud().and_then(|cloud| cloud.masses().get(number).copied()).unwrap_or(f64::NAN);
    let vector = |columns: &[Vec<f64>; 3], index: usize| Vector3::from_fn(|axis, _| columns[axis][index]);
    match channel {
        Channel::Position => {
            batch.vectors_at(columns, |index, _, state| state.position + vector(&particle.arm, index));
        }
        Channel::Velocity => {
            batch.vectors_at(columns, |index, _, state| state.velocity + vector(&particle.velocity, index));
        }
        Channel::Acceleration => {
            batch.vectors_at(columns, |index, _, _| vector(&particle.force, index) / mass + problem.gravity);
        }
        Channel::ForceWorld => batch.vectors_at(columns, |index, _, _| vector(&particle.force, index)),
        // No other is planned of a particle.
        _ => {}
    }
}
