use crate::dynamics::Problem;
use crate::numerics::DoubleDouble;
use crate::propagation::{PreciseState, States};
use crate::scenario::PlannedBody;

type Vector = [DoubleDouble; 3];

/// The largest differences between states in f64 and exact ones, so far.
#[derive(Debug)]
pub(super) struct Deviation {
    problem: Problem,
    /// Body and rotors together may have no momentum at all.
    largest_rotor_momentum: f64,
    attitude: f64,
    rates: Largest,
    momentum: Largest,
    position: f64,
    worst: f64,
    worst_at: f64,
}

/// The largest difference of a vector from the exact one, and the largest size of that.
#[derive(Debug, Default)]
struct Largest {
    difference: f64,
    size: f64,
}

impl Deviation {
    pub fn new(body: &PlannedBody) -> Self {
        Self {
            largest_rotor_momentum: body.problem.largest_rotor_momentum(),
            problem: body.problem.clone(),
            attitude: 0.0,
            rates: Largest::default(),
            momentum: Largest::default(),
            position: 0.0,
            worst: -1.0,
            worst_at: 0.0,
        }
    }

    /// Compares row `row` of the states, at `time` in s.
    pub fn include(&mut self, time: f64, states: &States, row: usize, exact: &PreciseState) {
        let omega = states.angular_velocity.each_ref().map(|column| DoubleDouble::from(column[row]));
        self.rates.include(omega, exact.angular_velocity);
        let mut measure = distance(omega, exact.angular_velocity);
        if !states.attitude[0].is_empty() {
            let q = states.attitude.each_ref().map(|column| DoubleDouble::from(column[row]));
            measure = angle(exact.attitude, q);
            self.attitude = self.attitude.max(measure);
            let rotor = self.problem.rotor_momentum(time).into();
            let exact = self.in_world(exact.attitude, exact.angular_velocity, rotor);
            self.momentum.include(self.in_world(q, omega, rotor), exact);
            self.momentum.size = self.momentum.size.max(self.largest_rotor_momentum);
        }
        if !states.position[0].is_empty() {
            let position = states.position.each_ref().map(|column| DoubleDouble::from(column[row]));
            self.position = self.position.max(distance(position, exact.position));
        }
        if measure > self.worst {
            (self.worst, self.worst_at) = (measure, time);
        }
    }

    /// rad.
    pub fn attitude(&self) -> f64 {
        self.attitude
    }

    /// Relative.
    pub fn angular_velocity(&self) -> f64 {
        self.rates.relative()
    }

    /// Relative.
    pub fn angular_momentum(&self) -> f64 {
        self.momentum.relative()
    }

    /// m.
    pub fn position(&self) -> f64 {
        self.position
    }

    /// s.
    pub fn worst_at(&self) -> f64 {
        self.worst_at
    }

    /// R (I ω + h) as v + 2 q × (q × v + w v), which needs no unit norm beyond rounding.
    fn in_world(&self, [w, x, y, z]: [DoubleDouble; 4], omega: Vector, rotor: [f64; 3]) -> Vector {
        let moments = self.problem.moments.vector();
        let v: Vector = std::array::from_fn(|i| omega[i] * moments[i] + rotor[i].into());
        let axis = [x, y, z];
        let first = cross(axis, v);
        let second = cross(axis, std::array::from_fn(|i| first[i] + w * v[i]));
        std::array::from_fn(|i| v[i] + second[i].scale(2.0))
    }
}

impl Largest {
    fn include(&mut self, found: Vector, exact: Vector) {
        self.difference = self.difference.max(distance(found, exact));
        self.size = self.size.max(length(exact));
    }

    fn relative(&self) -> f64 {
        if self.difference > 0.0 { self.difference / self.size } else { 0.0 }
    }
}

/// Angle between two attitudes, rad, however small: of p* q.
pub(super) fn angle(p: [DoubleDouble; 4], q: [DoubleDouble; 4]) -> f64 {
    let ([a, b, c, d], [w, x, y, z]) = (p, q);
    let imaginary = [a * x - b * w - c * z + d * y, a * y + b * z - c * w - d * x, a * z - b * y + c * x - d * w];
    let real = a * w + b * x + c * y + d * z;
    2.0 * libm::atan2(length(imaginary), real.hi().abs())
}

fn cross(u: Vector, v: Vector) -> Vector {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

pub(super) fn distance(a: Vector, b: Vector) -> f64 {
    length(std::array::from_fn(|i| a[i] - b[i]))
}

pub(super) fn length(vector: Vector) -> f64 {
    let [x, y, z] = vector.map(DoubleDouble::hi);
    libm::hypot(libm::hypot(x, y), z)
}
