use nalgebra::Vector3;

use super::drive::{Drive, Driver};
use crate::dynamics::{Problem, Torque};
use crate::numerics::DoubleDouble;

pub(super) type Vector = [DoubleDouble; 3];

/// All that acts during one span, as the constants of the equations of motion.
#[derive(Debug, Clone)]
pub(super) struct Acting {
    /// (I₂ − I₃)/I₁ and cyclic.
    pub coupling: Vector,
    /// I⁻¹ τ of moments constant in the body.
    pub moment: Vector,
    /// I⁻¹ A for each world axis: what its image in the body contributes to ω̇, by rows.
    pub couples: [[Vector; 3]; 3],
    /// c / I, and the rate of brakes along L.
    pub damping: Vector,
    /// What r₂r₃ and cyclic contribute to ω̇; n.
    pub gradient: Option<(Vector, f64)>,
    /// By forces constant in the body, if they are wanted.
    pub body_acceleration: Vector,
    /// By gravity and forces constant in the world, if they are wanted.
    pub world_acceleration: Vector,
    /// Whether any of this needs the rotation matrix.
    pub needs_matrix: bool,
    /// What changes with time.
    drivers: Vec<Driver>,
    inertia: Vector,
    /// Of a body whose translation is wanted.
    mass: Option<DoubleDouble>,
}

const ZERO: Vector = [DoubleDouble::ZERO; 3];

impl Acting {
    /// What acts at `time`, s. A force that moves the body needs its mass: `Schedule` has seen to that.
    pub fn at(problem: &Problem, time: f64) -> Self {
        let inertia = <[f64; 3]>::from(problem.moments.vector()).map(DoubleDouble::from);
        let cyclic = |i: usize| ((i + 1) % 3, (i + 2) % 3);
        let coupling = std::array::from_fn(|i| (inertia[cyclic(i).0] - inertia[cyclic(i).1]) / inertia[i]);
        let mut sum = Self {
            coupling,
            moment: ZERO,
            couples: [[ZERO; 3]; 3],
            damping: ZERO,
            gradient: None,
            body_acceleration: ZERO,
            world_acceleration: ZERO,
            needs_matrix: false,
            drivers: Vec::new(),
            inertia,
            mass: problem.mass.filter(|_| problem.wants_translation).map(DoubleDouble::from),
        };
        for load in problem.loads.iter().filter(|load| load.window.contains(time)) {
            sum.add(&load.torque, &inertia);
            sum.drivers.extend(Driver::of(&load.torque, time));
        }
        let mass = DoubleDouble::from(problem.mass.unwrap_or(1.0));
        let wanted = |force: Vector| if problem.wants_translation { force.map(|f| f / mass) } else { ZERO };
        sum.body_acceleration = wanted(sum.body_acceleration);
        sum.world_acceleration = wanted(sum.world_acceleration);
        for i in 0..3 {
            sum.moment[i] = sum.moment[i] / inertia[i];
            sum.damping[i] = sum.damping[i] / inertia[i];
            for rows in &mut sum.couples {
                rows[i] = rows[i].map(|value| value / inertia[i]);
            }
            if problem.wants_translation {
                sum.world_acceleration[i] += DoubleDouble::from(problem.gravity[i]);
            }
        }
        sum.needs_matrix = sum.gradient.is_some()
            || sum.drivers.iter().any(|driver| driver.needs_matrix(problem.wants_translation))
            || sum.couples.iter().flatten().chain([&sum.body_acceleration]).flatten().any(|value| !value.is_zero());
        sum
    }

    /// What changes with time, about `time`, for a series in `unit` seconds.
    pub fn drive(&self, time: DoubleDouble, unit: f64) -> Option<Drive> {
        let is_driven = !self.drivers.is_empty();
        is_driven.then(|| Drive::new(&self.drivers, self.inertia, self.mass, time, unit))
    }

    /// Moments and forces, not yet divided by moments of inertia and mass.
    fn add(&mut self, torque: &Torque, inertia: &Vector) {
        match *torque {
            // Drivers; and a problem with general loads goes by the general path, and not this way.
            Torque::ProfileBody { .. }
            | Torque::ProfileWorld { .. }
            | Torque::ForceProfileBody { .. }
            | Torque::ForceProfileWorld { .. }
            | Torque::Rotor { .. }
            | Torque::General(_) => {}
            Torque::ConstantBody { moment } => add(&mut self.moment, moment),
            Torque::LinearDamping { coefficient } => add(&mut self.damping, Vector3::repeat(coefficient)),
            Torque::MomentumBrake { rate } => {
                for i in 0..3 {
                    self.damping[i] += inertia[i] * DoubleDouble::from(rate);
                }
            }
            Torque::ForceBody { force, arm } => {
                for i in 0..3 {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    self.moment[i] += DoubleDouble::product(arm[j], force[k]) - DoubleDouble::product(arm[k], force[j]);
                }
                add(&mut self.body_acceleration, force);
            }
            Torque::ConstantWorld { moment } => self.add_couple(moment, &nalgebra::Matrix3::identity()),
            Torque::ForceWorld { force, arm } => {
                self.add_couple(force, &arm.cross_matrix());
                add(&mut self.world_acceleration, force);
            }
            Torque::MagneticDipole { dipole, field } => self.add_couple(field, &dipole.cross_matrix()),
            Torque::GravityGradient { mean_motion } => {
                let strength = DoubleDouble::product(mean_motion, mean_motion) * -3.0;
                let before = self.gradient.map_or(ZERO, |(factors, _)| factors);
                let factors = std::array::from_fn(|i| before[i] + self.coupling[i] * strength);
                self.gradient = Some((factors, mean_motion));
            }
        }
    }

    /// A moment A Rᵀ w.
    fn add_couple(&mut self, vector: Vector3<f64>, matrix: &nalgebra::Matrix3<f64>) {
        for axis in 0..3 {
            for i in 0..3 {
                for j in 0..3 {
                    self.couples[axis][i][j] += DoubleDouble::product(matrix[(i, j)], vector[axis]);
                }
            }
        }
    }
}

fn add(sum: &mut Vector, term: Vector3<f64>) {
    for i in 0..3 {
        sum[i] += DoubleDouble::from(term[i]);
    }
}
