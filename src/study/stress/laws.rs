use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::body::{AngularVelocity, Attitude, State};
use crate::comparison::{Growth, Trace};
use crate::dynamics::{MomentumLaw, Problem};
use crate::propagation::States;

/// How far a conserved quantity strays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drift {
    /// At worst, relative.
    pub largest: f64,
    /// By which law that grows, where one can be told.
    pub growth: Option<Growth>,
}

/// Watches energy and angular momentum of one run, and the length of its quaternions.
pub(super) struct Laws<'a> {
    problem: &'a Problem,
    initial_energy: Option<f64>,
    momentum: Option<(MomentumLaw, Vector3<f64>)>,
    of_energy: Watched,
    of_momentum: Watched,
    /// Largest | |q| − 1 |.
    pub norm: f64,
    /// Largest component of `RᵀR − 1`.
    pub orthogonality: f64,
    /// The last quaternion, and how often the next one was on the other side.
    last: Option<[f64; 4]>,
    pub sign_jumps: u64,
}

#[derive(Default)]
struct Watched {
    largest: f64,
    trace: Trace,
}

impl<'a> Laws<'a> {
    pub fn new(problem: &'a Problem) -> Self {
        let initial = &problem.initial;
        let momentum = problem.momentum_in_world(0.0, initial);
        Self {
            problem,
            initial_energy: problem.energy_law().map(|_| problem.total_energy(0.0, initial).0),
            momentum: problem.momentum_law().map(|law| (law, momentum)),
            of_energy: Watched::default(),
            of_momentum: Watched::default(),
            norm: 0.0,
            orthogonality: 0.0,
            last: None,
            sign_jumps: 0,
        }
    }

    /// Goes on by one state, all of it finite. The sign of q is watched as long as the run `follows` the motion: one that
    /// turns faster may jump.
    pub fn include(&mut self, time: f64, states: &States, row: usize, follows: bool) {
        let q = states.attitude.each_ref().map(|column| column[row]);
        let omega = states.angular_velocity.each_ref().map(|column| column[row]);
        let norm = q.iter().map(|component| component * component).sum::<f64>().sqrt();
        self.norm = self.norm.max((norm - 1.0).abs());
        let [w, x, y, z] = q;
        let turn = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        let matrix = turn.to_rotation_matrix().into_inner();
        self.orthogonality =
            self.orthogonality.max((matrix.transpose() * matrix - nalgebra::Matrix3::identity()).amax());
        if follows && self.last.is_some_and(|last| last.iter().zip(&q).map(|(a, b)| a * b).sum::<f64>() < 0.0) {
            self.sign_jumps += 1;
        }
        self.last = Some(q);
        let state = State {
            attitude: Attitude::from_world_from_body(turn),
            angular_velocity: AngularVelocity::from_vector(Vector3::from(omega)),
            ..self.problem.initial
        };
        if let Some(initial) = self.initial_energy {
            let (energy, size) = self.problem.total_energy(time, &state);
            self.of_energy.include(time, (energy - initial).abs(), size);
        }
        if let Some((law, initial)) = &self.momentum {
            let momentum = self.problem.momentum_in_world(time, &state);
            let size = initial.norm().max(momentum.norm());
            self.of_momentum.include(time, law.violation(time, initial, &momentum), size);
        }
    }

    /// Of the energy, if one is conserved.
    pub fn energy(&self) -> Option<Drift> {
        self.initial_energy.map(|_| self.of_energy.drift())
    }

    /// Of the angular momentum, whole or along an axis, if it follows a law.
    pub fn momentum(&self) -> Option<Drift> {
        self.momentum.as_ref().map(|_| self.of_momentum.drift())
    }
}

impl Watched {
    fn include(&mut self, time: f64, off: f64, size: f64) {
        let relative = if off > 0.0 { off / size } else { 0.0 };
        // What overflows is no measure of a drift.
        if relative.is_finite() {
            self.largest = self.largest.max(relative);
            self.trace.push(time, relative);
        }
    }

    fn drift(&self) -> Drift {
        Drift { largest: self.largest, growth: Growth::of(&self.trace, 1.0) }
    }
}
