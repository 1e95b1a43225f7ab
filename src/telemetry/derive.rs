use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::{BodySamples, Channel, FigureAxis};
use crate::body::{AngularVelocity, Attitude, State};
use crate::dynamics::{MomentumLaw, Problem, momentum_in_world, translational_energy};
use crate::propagation::States;

/// Makes channels of states: turns principal axes back into body axes, and knows the laws whose drift is watched.
#[derive(Debug, Clone)]
pub struct Derivation {
    problem: Problem,
    /// `None` where principal axes are body axes: then nothing is turned.
    body_from_principal: Option<UnitQuaternion<f64>>,
    momentum_law: Option<MomentumLaw>,
    figure: Option<FigureAxis>,
    initial_energy: f64,
    initial_energy_scale: f64,
    initial_momentum: Vector3<f64>,
}

impl Derivation {
    /// For states of `problem`; `body_from_principal` turns its axes into body axes.
    #[must_use]
    pub fn new(problem: &Problem, body_from_principal: UnitQuaternion<f64>) -> Self {
        let (initial_energy, initial_energy_scale) = problem.total_energy(0.0, &problem.initial);
        Self {
            body_from_principal: (body_from_principal != UnitQuaternion::identity()).then_some(body_from_principal),
            momentum_law: problem.momentum_law(),
            figure: FigureAxis::of(problem),
            initial_energy,
            initial_energy_scale,
            initial_momentum: momentum_in_world(problem.moments, &problem.initial),
            problem: problem.clone(),
        }
    }

    /// Fills the columns of `samples` from `states` at `times`.
    pub fn derive(&self, times: &[f64], states: &States, samples: &mut BodySamples) {
        for channel in Channel::ALL {
            let Some(columns) = samples.channel_mut(channel) else { continue };
            match channel {
                Channel::Attitude => self.attitude(states, columns),
                Channel::AngularVelocity if self.body_from_principal.is_none() => {
                    copy(&states.angular_velocity, columns);
                }
                Channel::RotationalEnergy => self.rotational_energy(states, columns),
                Channel::Position if !states.position[0].is_empty() => copy(&states.position, columns),
                Channel::Velocity if !states.velocity[0].is_empty() => copy(&states.velocity, columns),
                _ => self.state_by_state(channel, times, states, columns),
            }
        }
    }

    fn attitude(&self, states: &States, columns: &mut [Vec<f64>]) {
        let Some(body_from_principal) = self.body_from_principal else {
            return copy(&states.attitude, columns);
        };
        let principal_from_body = body_from_principal.inverse();
        clear(columns);
        for index in 0..states.len() {
            let attitude = attitude_at(states, index) * principal_from_body;
            for (column, component) in columns.iter_mut().zip([attitude.w, attitude.i, attitude.j, attitude.k]) {
                column.push(component);
            }
        }
    }

    fn rotational_energy(&self, states: &States, columns: &mut [Vec<f64>]) {
        let [i1, i2, i3]: [f64; 3] = self.problem.moments.vector().into();
        let [w1, w2, w3] = &states.angular_velocity;
        let energy = |((w1, w2), w3): ((&f64, &f64), &f64)| 0.5 * (i1 * w1 * w1 + i2 * w2 * w2 + i3 * w3 * w3);
        clear(columns);
        for column in columns {
            column.extend(w1.iter().zip(w2).zip(w3).map(energy));
        }
    }

    fn state_by_state(&self, channel: Channel, times: &[f64], states: &States, columns: &mut [Vec<f64>]) {
        clear(columns);
        for (index, time) in times.iter().enumerate() {
            let value = self.value(channel, *time, &self.state_at(states, index));
            for (column, component) in columns.iter_mut().zip(value.iter()) {
                column.push(*component);
            }
        }
    }

    /// A scalar stands in the first component.
    fn value(&self, channel: Channel, time: f64, state: &State) -> Vector3<f64> {
        let problem = &self.problem;
        let to_body = |in_principal| self.body_from_principal.map_or(in_principal, |turn| turn * in_principal);
        let scalar = |value| Vector3::new(value, 0.0, 0.0);
        let moment = || problem.moment(time, state);
        match channel {
            Channel::AngularVelocity => to_body(state.angular_velocity.in_body()),
            Channel::AngularVelocityWorld => state.attitude.to_world(&state.angular_velocity.in_body()),
            Channel::AngularMomentumWorld => momentum_in_world(problem.moments, state),
            Channel::AngularMomentumBody => to_body(state.angular_velocity.momentum(problem.moments).in_body()),
            Channel::MomentBody => to_body(moment()),
            Channel::MomentWorld => state.attitude.to_world(&moment()),
            Channel::ForceWorld => problem.force(time, state),
            Channel::Position => state.position,
            Channel::Velocity => state.velocity,
            Channel::TranslationalEnergy => scalar(problem.mass.map_or(0.0, |mass| translational_energy(mass, state))),
            Channel::PotentialEnergy => scalar(problem.potential_energy(time, state)),
            Channel::TotalEnergy => scalar(problem.total_energy(time, state).0),
            Channel::EnergyDrift => scalar(self.energy_drift(time, state)),
            Channel::MomentumDrift => scalar(self.momentum_drift(time, state)),
            Channel::Slip => scalar(self.slip(state)),
            Channel::Tilt => scalar(self.figure.map_or(0.0, |figure| figure.tilt(problem, time, state))),
            Channel::PrecessionRate => {
                scalar(self.figure.map_or(0.0, |figure| figure.precession_rate(problem, time, state)))
            }
            Channel::Attitude | Channel::RotationalEnergy => Vector3::zeros(),
        }
    }

    fn energy_drift(&self, time: f64, state: &State) -> f64 {
        let (energy, scale) = self.problem.total_energy(time, state);
        parts_per_1e15(energy - self.initial_energy, scale.max(self.initial_energy_scale))
    }

    fn momentum_drift(&self, time: f64, state: &State) -> f64 {
        let Some(law) = &self.momentum_law else { return 0.0 };
        let momentum = momentum_in_world(self.problem.moments, state);
        let scale = self.initial_momentum.norm().max(momentum.norm());
        parts_per_1e15(law.violation(time, &self.initial_momentum, &momentum), scale)
    }

    /// Poinsot: the body's point where the energy ellipsoid touches the plane across L(0) is along I⁻¹ L(0), and at rest.
    fn slip(&self, state: &State) -> f64 {
        if !self.problem.loads.is_empty() {
            return 0.0;
        }
        let momentum = state.attitude.to_body(&self.initial_momentum);
        let touching = momentum.component_div(&self.problem.moments.vector());
        let omega = state.angular_velocity.in_body();
        parts_per_1e15(omega.cross(&touching).norm(), omega.norm() * touching.norm())
    }

    /// What was not propagated stays as it was at t = 0: it is constant, or no channel looks at it.
    fn state_at(&self, states: &States, index: usize) -> State {
        let vector = |columns: &[Vec<f64>; 3], constant: &Vector3<f64>| {
            if columns[0].is_empty() { *constant } else { Vector3::from_fn(|row, _| columns[row][index]) }
        };
        let initial = &self.problem.initial;
        State {
            attitude: Attitude::from_world_from_body(attitude_at(states, index)),
            angular_velocity: AngularVelocity::from_vector(vector(&states.angular_velocity, &Vector3::zeros())),
            position: vector(&states.position, &initial.position),
            velocity: vector(&states.velocity, &initial.velocity),
        }
    }
}

/// World from principal; the identity where no attitude was propagated, as then no channel looks at it.
fn attitude_at(states: &States, index: usize) -> UnitQuaternion<f64> {
    let [w, x, y, z] = &states.attitude;
    if w.is_empty() {
        return UnitQuaternion::identity();
    }
    UnitQuaternion::new_unchecked(Quaternion::new(w[index], x[index], y[index], z[index]))
}

fn clear(columns: &mut [Vec<f64>]) {
    for column in columns {
        column.clear();
    }
}

fn copy(from: &[Vec<f64>], to: &mut [Vec<f64>]) {
    for (from, to) in from.iter().zip(to) {
        to.clear();
        to.extend_from_slice(from);
    }
}

fn parts_per_1e15(difference: f64, scale: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference / scale * 1e15 }
}
