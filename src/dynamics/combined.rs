use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::torque::{gradient_moment, radial_direction};
use super::{DynamicsError, GeneralLoad, Problem, Torque};
use crate::body::PrincipalMoments;

/// Everything that acts at once, summed into one term of each form.
#[derive(Debug, Clone, PartialEq)]
pub struct Combined {
    /// Moments constant in the body, with those of forces constant in the body, N m; principal axes.
    pub body_moment: Vector3<f64>,
    /// Moments of vectors constant in the world; at most three.
    pub couples: Vec<Couple>,
    /// c of −c ω, N m s.
    pub damping: f64,
    /// c of −c L, 1/s.
    pub brake: f64,
    /// The gravity gradient, if one acts.
    pub gradient: Option<Gradient>,
    /// Acceleration of the reference point by forces constant in the body, m/s²; principal axes. Zero if not wanted.
    pub body_acceleration: Vector3<f64>,
    /// Acceleration by gravity and by forces constant in the world, m/s²; world axes. Zero if not wanted.
    pub world_acceleration: Vector3<f64>,
    /// What does not add up so.
    pub general: Vec<Arc<GeneralLoad>>,
}

/// A moment A Rᵀ w, linear in the body image of a vector constant in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Couple {
    /// w: a moment in N m, a force in N, a field in T, or a world axis; world axes.
    pub vector: Vector3<f64>,
    /// A: the identity for a moment, arm × for a force, dipole × for a field; N m per unit of w, principal axes.
    pub matrix: Matrix3<f64>,
}

/// The moment k r × I r with r = Rᵀ (cos nt, sin nt, 0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gradient {
    /// n, rad/s.
    pub mean_motion: f64,
    /// k, 3 n² for each load, 1/s².
    pub strength: f64,
}

impl Gradient {
    /// The direction from the attracting centre at `time` + `rest` in s; unit, world axes.
    ///
    /// The phase n (time + rest) is rounded only once, however many orbits it holds.
    #[must_use]
    pub fn radial_at(&self, time: f64, rest: f64) -> Vector3<f64> {
        let phase = self.mean_motion * time;
        // What the product lost and the low part of the time adds: small enough for first order.
        let remainder = libm::fma(self.mean_motion, time, -phase) + self.mean_motion * rest;
        let (sine, cosine) = libm::sincos(phase);
        Vector3::new(cosine - remainder * sine, sine + remainder * cosine, 0.0)
    }
}

impl Combined {
    /// World vectors beyond which it is cheaper to take the three world axes.
    const MOST_COUPLES: usize = 3;

    /// The sum of those loads of a problem that act at `time`, s.
    ///
    /// # Errors
    /// If a force moves a body of unknown mass, or two different orbits act at once.
    pub fn at(problem: &Problem, time: f64) -> Result<Self, DynamicsError> {
        let mut sum = Self {
            body_moment: Vector3::zeros(),
            couples: Vec::new(),
            damping: 0.0,
            brake: 0.0,
            gradient: None,
            body_acceleration: Vector3::zeros(),
            general: Vec::new(),
            world_acceleration: if problem.wants_translation { problem.gravity } else { Vector3::zeros() },
        };
        for load in problem.loads.iter().filter(|load| load.window.contains(time)) {
            sum.add(&load.torque, problem)?;
        }
        sum.couples.retain(|couple| couple.vector != Vector3::zeros() && couple.matrix != Matrix3::zeros());
        if sum.couples.len() > Self::MOST_COUPLES {
            sum.couples = along_world_axes(&sum.couples);
        }
        Ok(sum)
    }

    fn add(&mut self, torque: &Torque, problem: &Problem) -> Result<(), DynamicsError> {
        match *torque {
            Torque::ConstantBody { moment } => self.body_moment += moment,
            Torque::ConstantWorld { moment } => self.add_couple(moment, Matrix3::identity()),
            Torque::LinearDamping { coefficient } => self.damping += coefficient,
            Torque::MomentumBrake { rate } => self.brake += rate,
            Torque::ForceBody { force, arm } => {
                self.body_moment += arm.cross(&force);
                self.body_acceleration += acceleration(force, problem)?;
            }
            Torque::ForceWorld { force, arm } => {
                self.add_couple(force, arm.cross_matrix());
                self.world_acceleration += acceleration(force, problem)?;
            }
            Torque::MagneticDipole { dipole, field } => self.add_couple(field, dipole.cross_matrix()),
            Torque::GravityGradient { mean_motion } => self.add_gradient(mean_motion)?,
            Torque::General(ref load) => {
                if load.kind.pushes() && problem.wants_translation && problem.mass.is_none() {
                    return Err(DynamicsError::NoMass);
                }
                self.general.push(Arc::clone(load));
            }
        }
        Ok(())
    }

    /// One image serves every couple with the same vector, or with the same matrix.
    fn add_couple(&mut self, vector: Vector3<f64>, matrix: Matrix3<f64>) {
        if let Some(same) = self.couples.iter_mut().find(|couple| couple.matrix == matrix) {
            same.vector += vector;
        } else if let Some(same) = self.couples.iter_mut().find(|couple| couple.vector == vector) {
            same.matrix += matrix;
        } else {
            self.couples.push(Couple { vector, matrix });
        }
    }

    fn add_gradient(&mut self, mean_motion: f64) -> Result<(), DynamicsError> {
        let strength = 3.0 * mean_motion * mean_motion;
        match &mut self.gradient {
            None => self.gradient = Some(Gradient { mean_motion, strength }),
            Some(same) if same.mean_motion == mean_motion => same.strength += strength,
            Some(_) => return Err(DynamicsError::TwoOrbits),
        }
        Ok(())
    }

    /// Whether the moment depends on the attitude.
    #[must_use]
    pub fn needs_attitude(&self) -> bool {
        !self.couples.is_empty()
            || self.gradient.is_some()
            || self.body_acceleration != Vector3::zeros()
            || !self.general.is_empty()
    }

    /// The moment at `time` in s, N m; `body_from_world` is the transposed rotation matrix, all in principal axes.
    #[must_use]
    pub fn moment(
        &self,
        moments: PrincipalMoments,
        time: f64,
        body_from_world: &Matrix3<f64>,
        omega: &Vector3<f64>,
    ) -> Vector3<f64> {
        let mut sum = self.body_moment - self.damping * omega - self.brake * moments.vector().component_mul(omega);
        for couple in &self.couples {
            sum += couple.matrix * (body_from_world * couple.vector);
        }
        if let Some(Gradient { mean_motion, strength }) = self.gradient {
            let radial = body_from_world * radial_direction(mean_motion, time);
            sum += gradient_moment(moments, strength, &radial);
        }
        sum
    }
}

fn acceleration(force: Vector3<f64>, problem: &Problem) -> Result<Vector3<f64>, DynamicsError> {
    match (problem.wants_translation, problem.mass) {
        (false, _) => Ok(Vector3::zeros()),
        (true, Some(mass)) => Ok(force / mass),
        (true, None) => Err(DynamicsError::NoMass),
    }
}

/// `Σ A Rᵀ w = Σ (Σ A w_e) Rᵀ e`, e the world axes: never more than three images, however many forces.
fn along_world_axes(couples: &[Couple]) -> Vec<Couple> {
    (0..3)
        .map(|axis| Couple {
            vector: Vector3::ith(axis, 1.0),
            matrix: couples.iter().map(|couple| couple.matrix * couple.vector[axis]).sum(),
        })
        .filter(|couple| couple.matrix != Matrix3::zeros())
        .collect()
}
