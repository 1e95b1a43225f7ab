use nalgebra::Vector3;

use super::row::Row;
use crate::dynamics::{Combined, EulerEquations};

/// The constants of the recurrence in one span, divided by the moments of inertia, time in the series' unit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Terms {
    /// The unit of time, s.
    pub unit: f64,
    /// (I₂ − I₃)/I₁ and cyclic.
    pub coupling: Row,
    /// Constant body moments, I⁻¹ τ.
    pub moment: Row,
    /// I⁻¹ A of each couple, by columns.
    pub couples: [[Row; 3]; 3],
    /// c / I, and the brake's rate.
    pub damping: Row,
    /// What r₂r₃ and cyclic contribute to ω̇: −3 n² times `coupling`.
    pub gradient: Row,
    /// n.
    pub mean_motion: f64,
    /// By forces constant in the body.
    pub body_acceleration: [f64; 3],
    /// By gravity and forces constant in the world.
    pub world_acceleration: Row,
}

impl Terms {
    /// Time in s.
    pub fn new(euler: &EulerEquations, loads: &Combined) -> Self {
        let inertia = euler.inertia();
        let coupling = euler.coupling();
        let mut couples = [[Row::ZERO; 3]; 3];
        for (columns, couple) in couples.iter_mut().zip(&loads.couples) {
            for (column, of_matrix) in columns.iter_mut().zip(couple.matrix.column_iter()) {
                *column = row(of_matrix.component_div(&inertia));
            }
        }
        let damping = Vector3::repeat(loads.damping).component_div(&inertia).add_scalar(loads.brake);
        let strength = loads.gradient.map_or(0.0, |gradient| gradient.strength);
        Self {
            unit: 1.0,
            coupling: row(coupling),
            moment: row(loads.body_moment.component_div(&inertia)),
            couples,
            damping: row(damping),
            gradient: row(-strength * coupling),
            mean_motion: loads.gradient.map_or(0.0, |gradient| gradient.mean_motion),
            body_acceleration: loads.body_acceleration.into(),
            world_acceleration: row(loads.world_acceleration),
        }
    }

    /// From time in s to time in `unit` seconds, a power of two: not a bit is lost.
    pub fn in_unit(&self, unit: f64) -> Self {
        let square = unit * unit;
        let (once, twice) = (Row::splat(unit), Row::splat(square));
        Self {
            unit,
            coupling: self.coupling,
            moment: self.moment * twice,
            couples: self.couples.map(|columns| columns.map(|column| column * twice)),
            damping: self.damping * once,
            gradient: self.gradient * twice,
            mean_motion: self.mean_motion * unit,
            body_acceleration: self.body_acceleration.map(|value| value * square),
            world_acceleration: self.world_acceleration * twice,
        }
    }
}

fn row(vector: Vector3<f64>) -> Row {
    Row::from_vector(vector.into())
}
