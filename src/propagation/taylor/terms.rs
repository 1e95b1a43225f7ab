use nalgebra::Vector3;

use crate::dynamics::{Combined, EulerEquations};

/// The constants of the recurrence in one span, divided by the moments of inertia, time in the series' unit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Terms {
    /// The unit of time, s.
    pub unit: f64,
    /// (I₂ − I₃)/I₁ and cyclic.
    pub coupling: [f64; 3],
    /// Constant body moments, I⁻¹ τ.
    pub moment: [f64; 3],
    /// I⁻¹ A of each couple, by rows.
    pub couples: [[[f64; 3]; 3]; 3],
    /// c / I, and the brake's rate.
    pub damping: [f64; 3],
    /// What r₂r₃ and cyclic contribute to ω̇: −3 n² times `coupling`.
    pub gradient: [f64; 3],
    /// n.
    pub mean_motion: f64,
    /// By forces constant in the body.
    pub body_acceleration: [f64; 3],
    /// By gravity and forces constant in the world.
    pub world_acceleration: [f64; 3],
}

impl Terms {
    /// Time in s.
    pub fn new(euler: &EulerEquations, loads: &Combined) -> Self {
        let inertia = euler.inertia();
        let coupling = euler.coupling();
        let mut couples = [[[0.0; 3]; 3]; 3];
        for (rows, couple) in couples.iter_mut().zip(&loads.couples) {
            for (i, row) in rows.iter_mut().enumerate() {
                *row = std::array::from_fn(|j| couple.matrix[(i, j)] / inertia[i]);
            }
        }
        let strength = loads.gradient.map_or(0.0, |gradient| gradient.strength);
        Self {
            unit: 1.0,
            coupling: coupling.into(),
            moment: loads.body_moment.component_div(&inertia).into(),
            couples,
            damping: Vector3::repeat(loads.damping).component_div(&inertia).add_scalar(loads.brake).into(),
            gradient: (-strength * coupling).into(),
            mean_motion: loads.gradient.map_or(0.0, |gradient| gradient.mean_motion),
            body_acceleration: loads.body_acceleration.into(),
            world_acceleration: loads.world_acceleration.into(),
        }
    }

    /// From time in s to time in `unit` seconds, a power of two: not a bit is lost.
    pub fn in_unit(&self, unit: f64) -> Self {
        let by = |factor: f64| move |value: f64| value * factor;
        let square = unit * unit;
        Self {
            unit,
            coupling: self.coupling,
            moment: self.moment.map(by(square)),
            couples: self.couples.map(|rows| rows.map(|row| row.map(by(square)))),
            damping: self.damping.map(by(unit)),
            gradient: self.gradient.map(by(square)),
            mean_motion: self.mean_motion * unit,
            body_acceleration: self.body_acceleration.map(by(square)),
            world_acceleration: self.world_acceleration.map(by(square)),
        }
    }
}
