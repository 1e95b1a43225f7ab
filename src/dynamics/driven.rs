use nalgebra::{Matrix3, Vector3};

use super::profile::{Cubic, from, rate, value};

/// What changes with time within a span: cubics of the time since [`Self::start`].
#[derive(Debug, Clone, PartialEq)]
pub struct Driven {
    /// From when time counts, s.
    pub start: f64,
    /// Moments in the body, N m; principal axes.
    pub moment: Cubic,
    /// Moments A Rᵀ w(t): A as in [`Couple`](super::Couple), w in world axes.
    pub couples: Vec<(Matrix3<f64>, Cubic)>,
    /// h(t), the momentum of rotors relative to the body, N m s; principal axes.
    pub rotor: Cubic,
    /// Acceleration of the reference point by forces in the body, m/s²; principal axes. Zero if not wanted.
    pub body_acceleration: Cubic,
    /// Acceleration by forces in the world, m/s²; world axes. Zero if not wanted.
    pub world_acceleration: Cubic,
}

const NONE: Cubic = [Vector3::new(0.0, 0.0, 0.0); 4];

impl Driven {
    /// Nothing yet, from `start` on, s.
    #[must_use]
    pub const fn new(start: f64) -> Self {
        Self {
            start,
            moment: NONE,
            couples: Vec::new(),
            rotor: NONE,
            body_acceleration: NONE,
            world_acceleration: NONE,
        }
    }

    /// The same, counted from `time` + `rest` on, s.
    #[must_use]
    pub fn since(&self, time: f64, rest: f64) -> Self {
        let passed = (time - self.start) + rest;
        Self {
            start: time,
            moment: from(&self.moment, passed),
            couples: self.couples.iter().map(|(matrix, vector)| (*matrix, from(vector, passed))).collect(),
            rotor: from(&self.rotor, passed),
            body_acceleration: from(&self.body_acceleration, passed),
            world_acceleration: from(&self.world_acceleration, passed),
        }
    }

    /// A moment A Rᵀ w(t) more.
    pub(super) fn add_couple(&mut self, matrix: Matrix3<f64>, vector: &Cubic) {
        match self.couples.iter_mut().find(|couple| couple.0 == matrix) {
            Some((_, same)) => add(same, vector, 1.0),
            None => self.couples.push((matrix, *vector)),
        }
    }

    /// The moment at `time`, s, with what rotors do to the body: − ω × h − ḣ; N m, principal axes.
    #[must_use]
    pub fn moment_at(&self, time: f64, body_from_world: &Matrix3<f64>, omega: &Vector3<f64>) -> Vector3<f64> {
        let passed = time - self.start;
        let of_rotors = value(&self.rotor, passed).cross(omega) - rate(&self.rotor, passed);
        let of_world = self.couples.iter().map(|(matrix, vector)| matrix * (body_from_world * value(vector, passed)));
        of_world.fold(value(&self.moment, passed) + of_rotors, |sum, moment| sum + moment)
    }

    /// The acceleration of the reference point at `time`, s; m/s², world axes.
    #[must_use]
    pub fn acceleration_at(&self, time: f64, body_from_world: &Matrix3<f64>) -> Vector3<f64> {
        let passed = time - self.start;
        value(&self.world_acceleration, passed) + body_from_world.tr_mul(&value(&self.body_acceleration, passed))
    }
}

/// Adds a cubic times a number.
pub(super) fn add(sum: &mut Cubic, term: &Cubic, factor: f64) {
    for (sum, term) in sum.iter_mut().zip(term) {
        *sum += factor * term;
    }
}
