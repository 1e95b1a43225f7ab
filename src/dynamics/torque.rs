use std::sync::Arc;

use nalgebra::Vector3;

use super::{GeneralLoad, Profile};
use crate::body::{Moment, PrincipalMoments, State};

/// A moment that depends on time and state: a library user's own, for the Runge–Kutta methods.
pub trait TorqueModel {
    /// About the reference point, at `time` in s; `state` and the result in principal axes.
    fn moment(&self, time: f64, state: &State) -> Moment;
}

/// The span in which a load acts: `start ≤ t < end`, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// First instant, s; minus infinity for always.
    pub start: f64,
    /// First instant after it, s; infinity for ever.
    pub end: f64,
}

impl Window {
    /// From minus to plus infinity.
    pub const ALWAYS: Self = Self { start: f64::NEG_INFINITY, end: f64::INFINITY };

    /// Whether a load with this window acts at `time`.
    #[must_use]
    pub fn contains(self, time: f64) -> bool {
        self.start <= time && time < self.end
    }
}

/// What acts on a body. Vectors "in body" are in **principal** axes, arms go from the reference point.
#[derive(Debug, Clone, PartialEq)]
pub enum Torque {
    /// τ = constant in the body, N m.
    ConstantBody {
        /// In principal axes, N m.
        moment: Vector3<f64>,
    },
    /// τ = Rᵀ (constant in the world), N m.
    ConstantWorld {
        /// In world axes, N m.
        moment: Vector3<f64>,
    },
    /// τ = −c ω.
    LinearDamping {
        /// c, N m s, not negative.
        coefficient: f64,
    },
    /// τ = −c I ω: where nothing else acts, every component of the angular momentum dies away alike, and its direction in
    /// the world stays.
    MomentumBrake {
        /// c, 1/s, not negative.
        rate: f64,
    },
    /// τ = arm × F, force F constant in the body: a thruster.
    ForceBody {
        /// In principal axes, N.
        force: Vector3<f64>,
        /// Where it acts, in principal axes, m.
        arm: Vector3<f64>,
    },
    /// τ = arm × Rᵀ F, force F constant in the world. Gravity about a pivot is F = m g at the centre of mass.
    ForceWorld {
        /// In world axes, N.
        force: Vector3<f64>,
        /// Where it acts, in principal axes, m.
        arm: Vector3<f64>,
    },
    /// τ = m × Rᵀ B `[Wertz78]`, of a dipole fixed in the body in a field fixed in the world; no force, as the field is
    /// uniform.
    MagneticDipole {
        /// m, in principal axes, A m².
        dipole: Vector3<f64>,
        /// B, in world axes, T.
        field: Vector3<f64>,
    },
    /// τ = a function of time, in the body.
    ProfileBody {
        /// In principal axes, N m.
        moment: Arc<Profile>,
    },
    /// τ = Rᵀ (a function of time, in the world).
    ProfileWorld {
        /// In world axes, N m.
        moment: Arc<Profile>,
    },
    /// τ = arm × F(t), a force in the body: thrusters that fire in pulses, or as was measured.
    ForceProfileBody {
        /// In principal axes, N.
        force: Arc<Profile>,
        /// Where it acts, in principal axes, m.
        arm: Vector3<f64>,
    },
    /// τ = arm × Rᵀ F(t), a force in the world.
    ForceProfileWorld {
        /// In world axes, N.
        force: Arc<Profile>,
        /// Where it acts, in principal axes, m.
        arm: Vector3<f64>,
    },
    /// τ = −ω × h − ḣ: what rotors inside do to the body that carries them, a gyrostat `[Hughes86]`. Nothing acts from
    /// outside: I ω + h, the angular momentum of both, changes by other loads alone.
    Rotor {
        /// h(t), continuous, of the rotors relative to the body, whose moments of inertia include them; principal axes,
        /// N m s.
        momentum: Arc<Profile>,
    },
    /// τ = 3 n² r × I r on a circular orbit in the world x-y plane, r = Rᵀ (cos nt, sin nt, 0).
    GravityGradient {
        /// n, rad/s.
        mean_motion: f64,
    },
    /// A kind without a recurrence of its own.
    General(Arc<GeneralLoad>),
}

/// A torque or force, and when it acts. A function of time in it counts from t = 0, not from the window's start.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// What acts.
    pub torque: Torque,
    /// When.
    pub window: Window,
}

impl Torque {
    /// The moment about the reference point at `time` in s, N m; principal axes.
    ///
    /// `moments` are the body's: the gravity gradient is theirs as much as the orbit's.
    #[must_use]
    pub fn moment(&self, moments: PrincipalMoments, time: f64, state: &State) -> Vector3<f64> {
        match *self {
            Self::ProfileBody { ref moment } => moment.at(time),
            Self::ProfileWorld { ref moment } => state.attitude.to_body(&moment.at(time)),
            Self::ForceProfileBody { ref force, arm } => arm.cross(&force.at(time)),
            Self::ForceProfileWorld { ref force, arm } => arm.cross(&state.attitude.to_body(&force.at(time))),
            Self::Rotor { ref momentum } => {
                momentum.at(time).cross(&state.angular_velocity.in_body()) - momentum.rate_at(time)
            }
            Self::ConstantBody { moment } => moment,
            Self::ConstantWorld { moment } => state.attitude.to_body(&moment),
            Self::LinearDamping { coefficient } => -coefficient * state.angular_velocity.in_body(),
            Self::MomentumBrake { rate } => -rate * moments.vector().component_mul(&state.angular_velocity.in_body()),
            Self::ForceBody { force, arm } => arm.cross(&force),
            Self::ForceWorld { force, arm } => arm.cross(&state.attitude.to_body(&force)),
            Self::MagneticDipole { dipole, field } => dipole.cross(&state.attitude.to_body(&field)),
            Self::GravityGradient { mean_motion } => {
                let radial = state.attitude.to_body(&radial_direction(mean_motion, time));
                gradient_moment(moments, 3.0 * mean_motion * mean_motion, &radial)
            }
            Self::General(ref load) => load.moment(time, state),
        }
    }

    /// The force on the reference point at `time` in s, N; world axes. Zero for pure moments.
    #[must_use]
    pub fn force(&self, time: f64, state: &State) -> Vector3<f64> {
        match *self {
            Self::ForceProfileBody { ref force, .. } => state.attitude.to_world(&force.at(time)),
            Self::ForceProfileWorld { ref force, .. } => force.at(time),
            Self::ForceBody { force, .. } => state.attitude.to_world(&force),
            Self::ForceWorld { force, .. } => force,
            Self::General(ref load) => load.force(time, state),
            _ => Vector3::zeros(),
        }
    }

    /// What it knows as a function of time, if it is one.
    #[must_use]
    pub fn profile(&self) -> Option<&Arc<Profile>> {
        match self {
            Self::ProfileBody { moment: profile }
            | Self::ProfileWorld { moment: profile }
            | Self::ForceProfileBody { force: profile, .. }
            | Self::ForceProfileWorld { force: profile, .. }
            | Self::Rotor { momentum: profile } => Some(profile),
            _ => None,
        }
    }

    /// The same, to be replaced.
    pub fn profile_mut(&mut self) -> Option<&mut Arc<Profile>> {
        match self {
            Self::ProfileBody { moment: profile }
            | Self::ProfileWorld { moment: profile }
            | Self::ForceProfileBody { force: profile, .. }
            | Self::ForceProfileWorld { force: profile, .. }
            | Self::Rotor { momentum: profile } => Some(profile),
            _ => None,
        }
    }

    /// Whether it is a force, which moves the reference point.
    #[must_use]
    pub fn is_force(&self) -> bool {
        match self {
            Self::ForceBody { .. }
            | Self::ForceWorld { .. }
            | Self::ForceProfileBody { .. }
            | Self::ForceProfileWorld { .. } => true,
            Self::General(load) => load.kind.pushes(),
            _ => false,
        }
    }

    /// Whether it acts between the body and what it carries, and so on no total.
    #[must_use]
    pub const fn is_internal(&self) -> bool {
        matches!(self, Self::Rotor { .. })
    }

    /// Whether the motion under it depends on the attitude; a force's also by where it `moves` the body.
    pub(super) fn needs_attitude(&self, moves: bool) -> bool {
        let zero = Vector3::zeros();
        match *self {
            Self::ConstantBody { .. }
            | Self::LinearDamping { .. }
            | Self::MomentumBrake { .. }
            | Self::ProfileBody { .. }
            | Self::Rotor { .. } => false,
            Self::ConstantWorld { moment } => moment != zero,
            Self::ForceBody { force, .. } => moves && force != zero,
            Self::ForceProfileBody { .. } => moves,
            Self::ForceWorld { force: one, arm: other } | Self::MagneticDipole { dipole: one, field: other } => {
                one != zero && other != zero
            }
            Self::ForceProfileWorld { arm, .. } => arm != zero,
            Self::ProfileWorld { .. } | Self::GravityGradient { .. } | Self::General(_) => true,
        }
    }
}

impl Load {
    /// The moment about the reference point at `time` in s, N m, principal axes; zero outside the window.
    #[must_use]
    pub fn moment(&self, moments: PrincipalMoments, time: f64, state: &State) -> Vector3<f64> {
        if self.window.contains(time) { self.torque.moment(moments, time, state) } else { Vector3::zeros() }
    }

    /// The force on the reference point at `time` in s, N, world axes; zero outside the window.
    #[must_use]
    pub fn force(&self, time: f64, state: &State) -> Vector3<f64> {
        if self.window.contains(time) { self.torque.force(time, state) } else { Vector3::zeros() }
    }
}

/// From the attracting centre to a body on a circular orbit in the world x-y plane; unit, world axes.
#[must_use]
pub(crate) fn radial_direction(mean_motion: f64, time: f64) -> Vector3<f64> {
    let (sine, cosine) = libm::sincos(mean_motion * time);
    Vector3::new(cosine, sine, 0.0)
}

/// k r × I r, with differences of moments taken first: r × I r would cancel on a nearly round body.
#[must_use]
pub(crate) fn gradient_moment(moments: PrincipalMoments, strength: f64, radial: &Vector3<f64>) -> Vector3<f64> {
    let inertia = moments.vector();
    strength
        * Vector3::new(
            (inertia.z - inertia.y) * (radial.y * radial.z),
            (inertia.x - inertia.z) * (radial.z * radial.x),
            (inertia.y - inertia.x) * (radial.x * radial.y),
        )
}
