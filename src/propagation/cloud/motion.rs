use std::sync::Arc;

use super::vector::{Vector, difference, dot};
use crate::dynamics::SpringCloud;
use crate::numerics::{DoubleDouble, Scalar};

/// A cloud and the lengths of its springs in all digits.
#[derive(Debug, Clone)]
pub(super) struct Springs {
    pub cloud: Arc<SpringCloud>,
    pub pairs: Arc<[[usize; 2]]>,
    /// ℓ₀², m².
    squares: Arc<[DoubleDouble]>,
}

/// Of one spring at one instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    /// d, from the first particle to the second, world axes, m.
    pub between: Vector<DoubleDouble>,
    /// q = ℓ² − ℓ₀², m².
    pub square: DoubleDouble,
    /// d·ḋ, m²/s.
    pub half_rate: DoubleDouble,
}

/// Where all particles are and how they move relative to the centre of mass, world axes, in 106 bits whatever the series
/// are in.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    /// m.
    pub positions: Vec<Vector<DoubleDouble>>,
    /// m/s.
    pub velocities: Vec<Vector<DoubleDouble>>,
}

impl Springs {
    /// Of a cloud, its places taken as exact.
    pub fn new(cloud: &SpringCloud) -> Self {
        let pairs: Arc<[_]> = cloud.pairs().collect();
        let place = |particle: usize| <[f64; 3]>::from(cloud.places()[particle]).map(DoubleDouble::from);
        let square = |[first, second]: &[usize; 2]| {
            let between = difference(place(*second), place(*first));
            dot(between, between)
        };
        Self { squares: pairs.iter().map(square).collect(), pairs, cloud: Arc::new(cloud.clone()) }
    }

    /// ℓ₀², m², in f64.
    pub fn rest_squares(&self) -> Vec<f64> {
        self.squares.iter().map(|square| square.hi()).collect()
    }

    /// Of every spring.
    pub fn stretches<'a>(&'a self, motion: &'a Motion) -> impl Iterator<Item = Stretch> + 'a {
        self.pairs.iter().zip(self.squares.iter()).map(|([first, second], rest)| {
            let between = difference(motion.positions[*second], motion.positions[*first]);
            let parting = difference(motion.velocities[*second], motion.velocities[*first]);
            Stretch { between, square: dot(between, between) - *rest, half_rate: dot(between, parting) }
        })
    }

    /// The net force of the springs on each particle, world axes, N, and the energy that they hold, J.
    pub fn forces(&self, motion: &Motion) -> (Vec<Vector<f64>>, f64) {
        let springs = self.cloud.springs();
        let (mut forces, mut energy) = (vec![[0.0; 3]; motion.positions.len()], 0.0);
        for ((stretch, [first, second]), rest) in self.stretches(motion).zip(self.pairs.iter()).zip(self.squares.iter())
        {
            let (square, rest_square) = (stretch.square.hi(), rest.hi());
            let length_square = rest_square + square;
            let (length, rest) = (length_square.sqrt(), rest_square.sqrt());
            let longer = square / (length + rest);
            energy += 0.5 * springs.stiffness * longer * longer;
            let factor = springs.stiffness * longer / length + springs.damping * stretch.half_rate.hi() / length_square;
            for axis in 0..3 {
                let pull = factor * stretch.between[axis].hi();
                forces[*first][axis] += pull;
                forces[*second][axis] -= pull;
            }
        }
        (forces, energy)
    }
}

impl Motion {
    pub fn is_finite(&self) -> bool {
        self.positions.iter().chain(&self.velocities).flatten().all(|value| (value.hi() + value.lo()).is_finite())
    }

    /// In another scalar.
    pub fn rounded<F: Scalar>(vector: Vector<DoubleDouble>) -> Vector<F> {
        vector.map(F::from_double)
    }
}
