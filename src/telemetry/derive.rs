use nalgebra::{UnitQuaternion, Vector3};

use super::batch::Batch;
use super::{BodySamples, Channel, Encircled, EulerSequence, FigureAxis, FigureFrame, Mounting, separatrix_distance};
use crate::body::State;
use crate::dynamics::{InnerSphere, Kovalevskaya, MomentumLaw, Problem, rotational_energy, translational_energy};
use crate::propagation::States;

/// Makes channels of states: turns principal axes back into body axes, and knows the laws whose drift is watched.
#[derive(Debug, Clone)]
pub struct Derivation {
    problem: Problem,
    /// `None` where principal axes are body axes: then nothing is turned.
    body_from_principal: Option<UnitQuaternion<f64>>,
    momentum_law: Option<MomentumLaw>,
    figure: Option<FigureAxis>,
    figure_frame: Option<FigureFrame>,
    encircled: Option<Encircled>,
    kovalevskaya: Option<Kovalevskaya>,
    initial_energy: f64,
    initial_energy_scale: f64,
    initial_momentum: Vector3<f64>,
    sphere: Option<InnerSphere>,
    reference_point: Mounting,
    largest_rotor_momentum: f64,
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
            figure_frame: FigureFrame::of(problem),
            encircled: Encircled::of(problem),
            kovalevskaya: Kovalevskaya::of(problem),
            initial_energy,
            initial_energy_scale,
            initial_momentum: initial_momentum(problem),
            largest_rotor_momentum: problem.largest_rotor_momentum(),
            sphere: problem.inner_sphere(),
            reference_point: Mounting::at_reference_point(body_from_principal),
            problem: problem.clone(),
        }
    }

    /// The same of a body that is held at its reference point, which no load tells.
    #[must_use]
    pub fn held(mut self) -> Self {
        self.reference_point.held_against = Some(Vector3::zeros());
        self
    }

    /// Fills the columns of `samples` from `states` at `times`.
    pub fn derive(&self, times: &[f64], states: &States, samples: &mut BodySamples) {
        let batch = Batch { times, states, initial: &self.problem.initial };
        for channel in Channel::ALL {
            let Some(columns) = samples.channel_mut(channel) else { continue };
            // Out of the samples meanwhile: some channels are made of others, or along with them.
            let mut columns: Vec<_> = columns.iter_mut().map(std::mem::take).collect();
            self.fill(channel, &batch, samples, &mut columns);
            if let Some(sphere) = self.sphere {
                self.add_sphere(sphere, channel, &batch, &mut columns);
            }
            if !states.cloud.particles.is_empty() {
                self.add_particles(channel, &batch, &mut columns);
            }
            for (place, column) in samples.channel_mut(channel).into_iter().flatten().zip(columns) {
                *place = column;
            }
        }
    }

    /// Each channel in a loop of its own, which takes of a state no more than it needs.
    fn fill(&self, channel: Channel, batch: &Batch<'_>, samples: &mut BodySamples, columns: &mut [Vec<f64>]) {
        let (problem, states) = (&self.problem, batch.states);
        let to_body = |in_principal| self.body_from_principal.map_or(in_principal, |turn| turn * in_principal);
        let moment = |time, state: &State| problem.external_moment(time, state);
        match channel {
            Channel::Attitude => self.attitude(batch, columns),
            Channel::AngularVelocity if self.body_from_principal.is_none() => copy(&states.angular_velocity, columns),
            Channel::AngularVelocity => batch.vectors(columns, |_, state| to_body(state.angular_velocity.in_body())),
            Channel::AngularVelocityWorld => {
                batch.vectors(columns, |_, state| state.attitude.to_world(&state.angular_velocity.in_body()));
            }
            Channel::AngularMomentumWorld => {
                batch.vectors(columns, |time, state| problem.momentum_in_world(time, state));
            }
            Channel::AngularMomentumBody => {
                batch.vectors(columns, |time, state| to_body(problem.momentum_in_body(time, state)));
            }
            Channel::MomentBody => batch.vectors(columns, |time, state| to_body(moment(time, state))),
            Channel::MomentWorld => {
                batch.vectors(columns, |time, state| state.attitude.to_world(&moment(time, state)));
            }
            Channel::ForceWorld => batch.vectors(columns, |time, state| problem.force(time, state)),
            Channel::Position => batch.vectors(columns, |_, state| state.position),
            Channel::Velocity => batch.vectors(columns, |_, state| state.velocity),
            Channel::RotationalEnergy => self.rotational_energy(states, columns),
            Channel::TranslationalEnergy => {
                let energy = |state: &State| problem.mass.map_or(0.0, |mass| translational_energy(mass, state));
                batch.scalars(columns, |_, _, state| energy(state));
            }
            Channel::PotentialEnergy => {
                batch.scalars(columns, |_, time, state| problem.potential_energy(time, state));
            }
            Channel::TotalEnergy => {
                let drifts = samples.channel_mut(Channel::EnergyDrift).and_then(<[_]>::first_mut);
                self.total_energy(batch, drifts, columns);
            }
            // Made along with the energy, if that is watched.
            Channel::EnergyDrift if samples.channel(Channel::TotalEnergy).is_some() => {}
            Channel::EnergyDrift => batch.scalars(columns, |_, time, state| {
                let (energy, scale) = problem.total_energy(time, state);
                self.energy_drift(energy, scale)
            }),
            Channel::MomentumDrift => self.momentum_drifts(batch, samples, columns),
            Channel::Slip => self.slips(batch, columns),
            Channel::Tilt => {
                let tilt = |figure: FigureAxis, time, state: &State| figure.tilt(problem, time, state);
                batch.scalars(columns, |_, time, state| self.figure.map_or(0.0, |figure| tilt(figure, time, state)));
            }
            Channel::PrecessionRate => {
                let rate = |figure: FigureAxis, time, state: &State| figure.precession_rate(problem, time, state);
                batch.scalars(columns, |_, time, state| self.figure.map_or(0.0, |figure| rate(figure, time, state)));
            }
            Channel::EulerZxz => self.euler_angles(EulerSequence::Zxz, batch, columns),
            Channel::EulerZyz => self.euler_angles(EulerSequence::Zyz, batch, columns),
            Channel::EulerZyx => self.euler_angles(EulerSequence::Zyx, batch, columns),
            Channel::EulerXyz => self.euler_angles(EulerSequence::Xyz, batch, columns),
            Channel::FigureAngles => batch.vectors(columns, |_, state| {
                let angles = self.figure_frame.map(|frame| frame.angles(&state.attitude.world_from_body()));
                angles.unwrap_or_default().into()
            }),
            Channel::FigureRates => batch.vectors(columns, |_, state| {
                self.figure_frame.map(|frame| frame.rates(problem, state)).unwrap_or_default().into()
            }),
            Channel::MomentumTilt | Channel::PolhodePhase => batch.scalars(columns, |_, _, state| {
                let Some(encircled) = self.encircled else { return 0.0 };
                let omega = state.angular_velocity.in_body();
                if channel == Channel::MomentumTilt {
                    encircled.tilt(problem.moments, &omega)
                } else {
                    encircled.phase(problem.moments, &omega)
                }
            }),
            Channel::SeparatrixDistance => batch.scalars(columns, |_, _, state| {
                separatrix_distance(problem.moments, &state.angular_velocity.in_body())
            }),
            Channel::KineticEnergy => batch.scalars(columns, |_, _, state| {
                let translational = problem.mass.map_or(0.0, |mass| translational_energy(mass, state));
                rotational_energy(problem.moments, state) + translational
            }),
            Channel::JacobiIntegral => {
                batch.scalars(columns, |_, time, state| problem.jacobi_integral(time, state).unwrap_or_default());
            }
            Channel::KovalevskayaIntegral => batch.scalars(columns, |_, _, state| {
                self.kovalevskaya.as_ref().map_or(0.0, |integral| integral.value(state))
            }),
            Channel::Acceleration
            | Channel::PositionBody
            | Channel::VelocityBody
            | Channel::AccelerationBody
            | Channel::Gyroscope
            | Channel::Accelerometer => self.reference_point.read(problem, channel, batch, columns),
        }
    }

    /// Of the attitude of body axes.
    fn euler_angles(&self, sequence: EulerSequence, batch: &Batch<'_>, columns: &mut [Vec<f64>]) {
        let principal_from_body = self.body_from_principal.map(|turn| turn.inverse());
        batch.vectors(columns, |_, state| {
            let attitude = state.attitude.world_from_body();
            let attitude = principal_from_body.map_or(attitude, |turn| attitude * turn);
            sequence.angles(&attitude).into()
        });
    }

    /// Adds what a sphere inside the body has of momentum and energy beyond turning with it.
    fn add_sphere(&self, sphere: InnerSphere, channel: Channel, batch: &Batch<'_>, columns: &mut [Vec<f64>]) {
        for index in 0..batch.times.len() {
            let (state, inner) = (batch.state(index), batch.inner(index));
            let momentum = sphere.momentum(&inner);
            let added = match channel {
                Channel::AngularMomentumWorld => state.attitude.to_world(&momentum),
                Channel::AngularMomentumBody => self.body_from_principal.map_or(momentum, |turn| turn * momentum),
                Channel::RotationalEnergy | Channel::KineticEnergy | Channel::TotalEnergy => {
                    Vector3::repeat(sphere.energy(&state.angular_velocity.in_body(), &inner))
                }
                _ => return,
            };
            for (column, added) in columns.iter_mut().zip(&added) {
                column[index] += added;
            }
        }
    }

    /// Puts the motion of particles on springs in the place of the rigid body's, and adds what the springs hold.
    fn add_particles(&self, channel: Channel, batch: &Batch<'_>, columns: &mut [Vec<f64>]) {
        let momentum = |index| batch.momentum_of_particles(index).unwrap_or_default();
        match channel {
            Channel::AngularMomentumWorld => return batch.vectors_at(columns, |index, _, _| momentum(index)),
            Channel::AngularMomentumBody => {
                let turn = self.body_from_principal.unwrap_or_default();
                return batch.vectors_at(columns, |index, _, state| turn * state.attitude.to_body(&momentum(index)));
            }
            _ => {}
        }
        let (Some(column), cloud) = (columns.first_mut(), &batch.states.cloud) else { return };
        for (index, (kinetic, elastic)) in cloud.kinetic_energy.iter().zip(&cloud.elastic_energy).enumerate() {
            let state = batch.state(index);
            let of_whole = self.problem.mass.map_or(0.0, |mass| translational_energy(mass, &state));
            let of_gravity = self.problem.potential_energy(batch.times[index], &state);
            column[index] = match channel {
                Channel::KineticEnergy => of_whole + kinetic,
                Channel::PotentialEnergy => of_gravity + elastic,
                Channel::TotalEnergy => of_whole + of_gravity + (kinetic + elastic),
                _ => return,
            };
        }
    }

    fn attitude(&self, batch: &Batch<'_>, columns: &mut [Vec<f64>]) {
        let Some(body_from_principal) = self.body_from_principal else {
            return copy(&batch.states.attitude, columns);
        };
        let principal_from_body = body_from_principal.inverse();
        for column in columns.iter_mut() {
            column.resize(batch.states.len(), 0.0);
        }
        let [w, x, y, z] = columns else { return };
        for (index, (((w, x), y), z)) in w.iter_mut().zip(x).zip(y).zip(z).enumerate() {
            let attitude = batch.attitude(index) * principal_from_body;
            (*w, *x, *y, *z) = (attitude.w, attitude.i, attitude.j, attitude.k);
        }
    }

    fn rotational_energy(&self, states: &States, columns: &mut [Vec<f64>]) {
        let [i1, i2, i3]: [f64; 3] = self.problem.moments.vector().into();
        let [w1, w2, w3] = &states.angular_velocity;
        let energy = |((w1, w2), w3): ((&f64, &f64), &f64)| 0.5 * (i1 * w1 * w1 + i2 * w2 * w2 + i3 * w3 * w3);
        for column in columns {
            column.clear();
            column.extend(w1.iter().zip(w2).zip(w3).map(energy));
        }
    }

    /// The total energy, and its drift where that is watched too.
    fn total_energy(&self, batch: &Batch<'_>, drifts: Option<&mut Vec<f64>>, columns: &mut [Vec<f64>]) {
        let total = |time, state: &State| self.problem.total_energy(time, state);
        let Some(drifts) = drifts else { return batch.scalars(columns, |_, time, state| total(time, state).0) };
        drifts.clear();
        batch.scalars(columns, |_, time, state| {
            let (energy, scale) = total(time, state);
            drifts.push(self.energy_drift(energy, scale));
            energy
        });
    }

    fn energy_drift(&self, energy: f64, scale: f64) -> f64 {
        parts_per_1e15(energy - self.initial_energy, scale.max(self.initial_energy_scale))
    }

    /// From L in world axes, which is not worked out again where it is watched.
    fn momentum_drifts(&self, batch: &Batch<'_>, samples: &BodySamples, columns: &mut [Vec<f64>]) {
        let Some(law) = &self.momentum_law else { return batch.scalars(columns, |_, _, _| 0.0) };
        let initial = &self.initial_momentum;
        // Body and rotors together may have no momentum at all.
        let initial_norm = initial.norm().max(self.largest_rotor_momentum);
        let drift = |time, momentum: &Vector3<f64>| {
            parts_per_1e15(law.violation(time, initial, momentum), initial_norm.max(momentum.norm()))
        };
        match samples.channel(Channel::AngularMomentumWorld) {
            Some([x, y, z]) => {
                let momentum = |index: usize| Vector3::new(x[index], y[index], z[index]);
                batch.scalars(columns, |index, time, _| drift(time, &momentum(index)));
            }
            _ => batch.scalars(columns, |index, time, state| {
                if let Some(momentum) = batch.momentum_of_particles(index) {
                    return drift(time, &momentum);
                }
                let momentum = self.problem.momentum_in_world(time, state);
                let whole =
                    self.sphere.map(|sphere| momentum + state.attitude.to_world(&sphere.momentum(&batch.inner(index))));
                drift(time, &whole.unwrap_or(momentum))
            }),
        }
    }

    /// Poinsot: the body's point where the energy ellipsoid touches the plane across L(0) is along I⁻¹ L(0), and at rest.
    fn slips(&self, batch: &Batch<'_>, columns: &mut [Vec<f64>]) {
        if !self.problem.loads.is_empty() {
            return batch.scalars(columns, |_, _, _| 0.0);
        }
        batch.scalars(columns, |_, _, state| {
            let momentum = state.attitude.to_body(&self.initial_momentum);
            let touching = momentum.component_div(&self.problem.moments.vector());
            let omega = state.angular_velocity.in_body();
            parts_per_1e15(omega.cross(&touching).norm(), omega.norm() * touching.norm())
        });
    }
}

/// R (I ω + h + J σ) at t = 0.
fn initial_momentum(problem: &Problem) -> Vector3<f64> {
    let momentum = problem.momentum_in_world(0.0, &problem.initial);
    let of_sphere = |sphere: InnerSphere| problem.initial.attitude.to_world(&sphere.momentum(&sphere.initial));
    problem.inner_sphere().map_or(momentum, |sphere| momentum + of_sphere(sphere))
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
