use nalgebra::Vector3;

use super::row::Row;
use super::series::Series;
use super::sums::Instant;
use crate::dynamics::{Driven, EulerEquations};
use crate::numerics::Four;

/// The highest power of time in what changes with time.
const DEGREE: usize = 3;

/// What changes with time, as polynomials of the series' σ over one step; divided by moments of inertia, time in the
/// series' unit.
#[derive(Debug, Clone)]
pub(super) struct Drive {
    /// I⁻¹ (τ − ḣ).
    moment: [Row; DEGREE + 1],
    /// I⁻¹ A w, by columns, for each order and each world axis.
    couples: [[[Row; 3]; 3]; DEGREE + 1],
    has_couples: bool,
    /// (h₂, h₃, h₁) and (h₃, h₁, h₂), both as I⁻¹ takes them.
    rotor: [[Row; 2]; DEGREE + 1],
    /// By forces in the body.
    pub body_acceleration: [[f64; 3]; DEGREE + 1],
    /// By forces in the world.
    pub world_acceleration: [Row; DEGREE + 1],
}

impl Drive {
    /// From what drives the body to its polynomials about `time`.
    pub fn new(driven: &Driven, euler: &EulerEquations, time: Instant, unit: f64) -> Self {
        let driven = driven.since(time.high, time.low);
        let inertia = euler.inertia();
        let row = |vector: Vector3<f64>| Row::from_vector(vector.into());
        // Times unit^power. Of a body at rest for ever the unit is so long that its powers are infinite; zero stays zero.
        let scaled = |vector: Vector3<f64>, power: usize| {
            if vector == Vector3::zeros() { vector } else { (0..power).fold(vector, |vector, _| vector * unit) }
        };
        let mut drive = Self {
            moment: [Row::ZERO; DEGREE + 1],
            couples: [[[Row::ZERO; 3]; 3]; DEGREE + 1],
            has_couples: !driven.couples.is_empty(),
            rotor: [[Row::ZERO; 2]; DEGREE + 1],
            body_acceleration: [[0.0; 3]; DEGREE + 1],
            world_acceleration: [Row::ZERO; DEGREE + 1],
        };
        let factors = [1.0, 2.0, 3.0];
        for order in 0..=DEGREE {
            let spin_up = if order < DEGREE { factors[order] * driven.rotor[order + 1] } else { Vector3::zeros() };
            let moment = (driven.moment[order] - spin_up).component_div(&inertia);
            drive.moment[order] = row(scaled(moment, order + 2));
            let [x, y, z]: [f64; 3] = scaled(driven.rotor[order], order + 1).into();
            drive.rotor[order] = [Vector3::new(y, z, x), Vector3::new(z, x, y)].map(|h| row(h.component_div(&inertia)));
            drive.body_acceleration[order] = scaled(driven.body_acceleration[order], order + 2).into();
            drive.world_acceleration[order] = row(scaled(driven.world_acceleration[order], order + 2));
            for (matrix, vector) in &driven.couples {
                for axis in 0..3 {
                    for column in 0..3 {
                        let of_column = matrix.column(column).component_div(&inertia);
                        drive.couples[order][axis][column] += row(scaled(vector[order][axis] * of_column, order + 2));
                    }
                }
            }
        }
        drive
    }

    /// How fast rotors turn the body at the step's start, in the series' unit.
    pub fn turning(&self) -> f64 {
        let [[one, other], ..] = self.rotor;
        one.largest(other).magnitude()
    }

    /// Whether it moves the reference point.
    pub fn moves(&self) -> bool {
        self.body_acceleration != [[0.0; 3]; DEGREE + 1] || self.world_acceleration != [Row::ZERO; DEGREE + 1]
    }

    /// Coefficient k of what it adds to ω̇, from those of ω and of the images of the world axes up to k.
    #[inline(always)]
    pub fn rates<F: Four>(&self, proof: F::Proof, series: &Series, k: usize) -> F {
        let own = if k <= DEGREE { &self.moment[k] } else { &Row::ZERO };
        let mut sum = own.load::<F>(proof);
        for order in 0..=k.min(DEGREE) {
            let [omega, turned]: [F; 2] = series.rates.load(proof, k - order);
            let [next, last] = &self.rotor[order];
            // h × ω.
            sum = sum + (next.load::<F>(proof) * omega.turned_back() - last.load::<F>(proof) * turned);
            if self.has_couples {
                for (columns, image) in self.couples[order].iter().zip(&series.images) {
                    for (column, component) in columns.iter().zip(image.rows[k - order].0) {
                        sum = sum + column.load::<F>(proof) * F::splat(proof, component);
                    }
                }
            }
        }
        sum
    }
}
