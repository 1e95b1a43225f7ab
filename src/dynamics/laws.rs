use std::sync::Arc;

use nalgebra::Vector3;

use super::invariants::{
    jacobi_integral, momentum_in_world, potential_energy, rotational_energy, translational_energy,
};
use super::{Load, Problem, Profile, Torque, Window};
use crate::body::State;

/// Which energy a motion conserves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EnergyLaw {
    /// Rotational, translational and potential energy together. With rotors of constant momentum, whose motors hold them
    /// at their speed, it is ½ ω·Iω that stays, what the motors give or take apart.
    Total,
    /// On a circular orbit, with the orbit's turning taken into account: `E + 3/2 n² r·Ir − n L_z`.
    Jacobi {
        /// n, rad/s.
        mean_motion: f64,
    },
}

/// What a motion does with its angular momentum: L − L₀ − ∫τ dt stays zero, whole or along one axis.
#[derive(Debug, Clone, PartialEq)]
pub struct MomentumLaw {
    /// The world axis along which the law holds; `None`: the whole vector.
    pub axis: Option<Vector3<f64>>,
    impulses: Vec<(Vector3<f64>, Window)>,
    profiles: Vec<(Arc<Profile>, Window)>,
}

impl Problem {
    /// The energy that stays constant, if the loads leave one.
    #[must_use]
    pub fn energy_law(&self) -> Option<EnergyLaw> {
        let acts_always = |load: &Load| load.window.start <= 0.0 && load.window.end == f64::INFINITY;
        match self.loads.as_slice() {
            [load @ Load { torque: Torque::GravityGradient { mean_motion }, .. }] if acts_always(load) => {
                Some(EnergyLaw::Jacobi { mean_motion: *mean_motion })
            }
            loads => {
                loads.iter().all(|load| acts_always(load) && conserves_energy(&load.torque)).then_some(EnergyLaw::Total)
            }
        }
    }

    /// What is known of the angular momentum, if anything.
    #[must_use]
    pub fn momentum_law(&self) -> Option<MomentumLaw> {
        let mut law = MomentumLaw { axis: None, impulses: Vec::new(), profiles: Vec::new() };
        for load in &self.loads {
            match load.torque {
                Torque::Rotor { .. } if load.window == Window::ALWAYS => {}
                Torque::ProfileWorld { ref moment } => law.profiles.push((Arc::clone(moment), load.window)),
                Torque::ForceProfileBody { arm, .. } | Torque::ForceProfileWorld { arm, .. }
                    if arm == Vector3::zeros() => {}
                Torque::ConstantWorld { moment } => law.impulses.push((moment, load.window)),
                Torque::ForceBody { force, arm } if arm.cross(&force) == Vector3::zeros() => {}
                Torque::ForceWorld { arm: vector, .. } | Torque::MagneticDipole { dipole: vector, .. }
                    if vector == Vector3::zeros() => {}
                Torque::ForceWorld { force, .. } | Torque::MagneticDipole { field: force, .. } => {
                    let axis = force.try_normalize(0.0)?;
                    if law.axis.is_some_and(|other| other.cross(&axis) != Vector3::zeros()) {
                        return None;
                    }
                    law.axis = Some(axis);
                }
                Torque::General(ref load) if load.kind.moves_inside().is_some() => {}
                Torque::ConstantBody { .. }
                | Torque::Rotor { .. }
                | Torque::ProfileBody { .. }
                | Torque::ForceProfileBody { .. }
                | Torque::ForceProfileWorld { .. }
                | Torque::ForceBody { .. }
                | Torque::LinearDamping { .. }
                | Torque::MomentumBrake { .. }
                | Torque::GravityGradient { .. }
                | Torque::General(_) => return None,
            }
        }
        Some(law)
    }

    /// Jacobi's integral in `state` at `time`, J; `None` unless one gravity gradient acts, all the time, alone or with other
    /// loads (which then change it).
    #[must_use]
    pub fn jacobi_integral(&self, time: f64, state: &State) -> Option<f64> {
        let mut motions = self.loads.iter().filter_map(|load| match load.torque {
            Torque::GravityGradient { mean_motion } => Some((mean_motion, load.window)),
            _ => None,
        });
        let (mean_motion, window) = motions.next()?;
        let is_alone = motions.next().is_none() && window.start <= 0.0 && window.end == f64::INFINITY;
        is_alone.then(|| jacobi_integral(mean_motion, self.moments, time, state))
    }

    /// Everything that turns the body at `time` in s, rotors too, about the reference point: N m, principal axes.
    #[must_use]
    pub fn moment(&self, time: f64, state: &State) -> Vector3<f64> {
        self.loads.iter().map(|load| load.moment(self.moments, time, state)).sum()
    }

    /// Everything that acts on the body from outside at `time` in s, about the reference point: N m, principal axes.
    #[must_use]
    pub fn external_moment(&self, time: f64, state: &State) -> Vector3<f64> {
        let external = self.loads.iter().filter(|load| !load.torque.is_internal());
        external.map(|load| load.moment(self.moments, time, state)).sum()
    }

    /// Everything that moves the reference point at `time` in s: N, world axes.
    #[must_use]
    pub fn force(&self, time: f64, state: &State) -> Vector3<f64> {
        let weight = self.mass.unwrap_or_default() * self.gravity;
        weight + self.loads.iter().map(|load| load.force(time, state)).sum::<Vector3<f64>>()
    }

    /// Energy of the loads and of gravity in `state`, J, as far as they have a potential.
    #[must_use]
    pub fn potential_energy(&self, time: f64, state: &State) -> f64 {
        let weight = -self.mass.unwrap_or_default() * self.gravity.dot(&state.position);
        let of_load = |load: &Load| potential_energy(&load.torque, self.moments, time, state).unwrap_or_default();
        weight + self.loads.iter().map(of_load).sum::<f64>()
    }

    /// The energy of [`Self::energy_law`] in `state`, J, and the sum of the magnitudes of its terms.
    #[must_use]
    pub fn total_energy(&self, time: f64, state: &State) -> (f64, f64) {
        let turning = match self.energy_law() {
            Some(EnergyLaw::Jacobi { mean_motion }) => -mean_motion * momentum_in_world(self.moments, state).z,
            Some(EnergyLaw::Total) | None => 0.0,
        };
        let terms = [
            rotational_energy(self.moments, state),
            self.mass.map_or(0.0, |mass| translational_energy(mass, state)),
            self.potential_energy(time, state),
            turning,
        ];
        (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum())
    }
}

/// Whether it has a potential, or does no work at all, as long as it acts.
fn conserves_energy(torque: &Torque) -> bool {
    match torque {
        Torque::ForceWorld { .. } | Torque::MagneticDipole { .. } => true,
        Torque::Rotor { momentum } => momentum.is_constant(),
        Torque::General(load) => load.kind.is_conservative(),
        _ => false,
    }
}

impl MomentumLaw {
    /// ∫τ dt from 0 to `time`, of the moments constant in the world, N m s.
    #[must_use]
    pub fn impulse(&self, time: f64) -> Vector3<f64> {
        let span = |window: &Window| (window.end.min(time) - window.start.max(0.0)).max(0.0);
        let constant: Vector3<f64> = self.impulses.iter().map(|(moment, window)| moment * span(window)).sum();
        let of = |profile: &Profile, window: &Window| profile.integral(window.start.max(0.0), window.end.min(time));
        self.profiles.iter().fold(constant, |sum, (profile, window)| sum + of(profile, window))
    }

    /// How far `momentum` (world axes) is from its law, N m s.
    #[must_use]
    pub fn violation(&self, time: f64, initial: &Vector3<f64>, momentum: &Vector3<f64>) -> f64 {
        let change = momentum - initial - self.impulse(time);
        self.axis.map_or_else(|| change.norm(), |axis| change.dot(&axis).abs())
    }
}
