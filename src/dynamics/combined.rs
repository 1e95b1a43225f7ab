use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::driven::add;
use super::torque::{gradient_moment, radial_direction};
use super::{Cubic, Driven, GeneralLoad, Problem, Torque};
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
    /// All that is not constant, and rotors. Where a moment in it turns with the world, `couples` are of the three world
    /// axes, in order.
    pub driven: Option<Box<Driven>>,
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

    /// The sum of those loads of a problem that act from `time`, s, on; that they make one equation of motion,
    /// [`Schedule`](super::Schedule) has seen to.
    pub(super) fn at(problem: &Problem, time: f64) -> Self {
        let mut sum = Self {
            body_moment: Vector3::zeros(),
            couples: Vec::new(),
            damping: 0.0,
            brake: 0.0,
            gradient: None,
            body_acceleration: Vector3::zeros(),
            world_acceleration: if problem.wants_translation { problem.gravity } else { Vector3::zeros() },
            driven: None,
            general: Vec::new(),
        };
        for load in problem.loads.iter().filter(|load| load.window.contains(time)) {
            sum.add(&load.torque, problem, time);
        }
        sum.couples.retain(|couple| couple.vector != Vector3::zeros() && couple.matrix != Matrix3::zeros());
        if sum.driven.as_ref().is_some_and(|driven| !driven.couples.is_empty()) {
            sum.couples = along_world_axes(&sum.couples).to_vec();
        } else if sum.couples.len() > Self::MOST_COUPLES {
            sum.couples = along_world_axes(&sum.couples).to_vec();
            sum.couples.retain(|couple| couple.matrix != Matrix3::zeros());
        }
        sum
    }

    fn add(&mut self, torque: &Torque, problem: &Problem, time: f64) {
        match *torque {
            Torque::ProfileBody { ref moment } => self.add_moment(&moment.piece_from(time), time),
            Torque::ProfileWorld { ref moment } => {
                self.add_driven_couple(Matrix3::identity(), &moment.piece_from(time), time);
            }
            Torque::ForceProfileBody { ref force, arm } => {
                let force = force.piece_from(time);
                self.add_moment(&force.map(|coefficient| arm.cross(&coefficient)), time);
                let [constant, ..] = force;
                if !is_driven(&force) {
                    self.body_acceleration += acceleration(constant, problem);
                } else if problem.wants_translation {
                    add(&mut self.driven(time).body_acceleration, &force, 1.0 / problem.mass.unwrap_or(1.0));
                }
            }
            Torque::ForceProfileWorld { ref force, arm } => {
                let force = force.piece_from(time);
                self.add_driven_couple(arm.cross_matrix(), &force, time);
                let [constant, ..] = force;
                if !is_driven(&force) {
                    self.world_acceleration += acceleration(constant, problem);
                } else if problem.wants_translation {
                    add(&mut self.driven(time).world_acceleration, &force, 1.0 / problem.mass.unwrap_or(1.0));
                }
            }
            Torque::Rotor { ref momentum } => add(&mut self.driven(time).rotor, &momentum.piece_from(time), 1.0),
            Torque::ConstantBody { moment } => self.body_moment += moment,
            Torque::ConstantWorld { moment } => self.add_couple(moment, Matrix3::identity()),
            Torque::LinearDamping { coefficient } => self.damping += coefficient,
            Torque::MomentumBrake { rate } => self.brake += rate,
            Torque::ForceBody { force, arm } => {
                self.body_moment += arm.cross(&force);
                self.body_acceleration += acceleration(force, problem);
            }
            Torque::ForceWorld { force, arm } => {
                self.add_couple(force, arm.cross_matrix());
                self.world_acceleration += acceleration(force, problem);
            }
            Torque::MagneticDipole { dipole, field } => self.add_couple(field, dipole.cross_matrix()),
            Torque::GravityGradient { mean_motion } => self.add_gradient(mean_motion),
            Torque::General(ref load) => self.general.push(Arc::clone(load)),
        }
    }

    fn driven(&mut self, start: f64) -> &mut Driven {
        self.driven.get_or_insert_with(|| Box::new(Driven::new(start)))
    }

    /// A moment in the body.
    fn add_moment(&mut self, moment: &Cubic, start: f64) {
        if is_driven(moment) { add(&mut self.driven(start).moment, moment, 1.0) } else { self.body_moment += moment[0] }
    }

    /// A moment A Rᵀ w(t).
    fn add_driven_couple(&mut self, matrix: Matrix3<f64>, vector: &Cubic, start: f64) {
        if matrix == Matrix3::zeros() {
            return;
        }
        if is_driven(vector) {
            self.driven(start).add_couple(matrix, vector);
        } else {
            self.add_couple(vector[0], matrix);
        }
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

    fn add_gradient(&mut self, mean_motion: f64) {
        let strength = 3.0 * mean_motion * mean_motion;
        match &mut self.gradient {
            None => self.gradient = Some(Gradient { mean_motion, strength }),
            Some(same) => same.strength += strength,
        }
    }

    /// The acceleration of the reference point at `time` in s, m/s², world axes.
    #[must_use]
    pub fn acceleration(&self, time: f64, body_from_world: &Matrix3<f64>) -> Vector3<f64> {
        let constant = self.world_acceleration + body_from_world.tr_mul(&self.body_acceleration);
        self.driven.as_ref().map_or(constant, |driven| constant + driven.acceleration_at(time, body_from_world))
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
        if let Some(driven) = &self.driven {
            sum += driven.moment_at(time, body_from_world, omega);
        }
        sum
    }
}

/// Zero where no translation is wanted.
fn acceleration(force: Vector3<f64>, problem: &Problem) -> Vector3<f64> {
    problem.mass.filter(|_| problem.wants_translation).map_or_else(Vector3::zeros, |mass| force / mass)
}

/// Whether it changes with time.
fn is_driven([_, rest @ ..]: &Cubic) -> bool {
    rest.iter().any(|coefficient| *coefficient != Vector3::zeros())
}

/// `Σ A Rᵀ w = Σ (Σ A w_e) Rᵀ e`, e the world axes: never more than three images, however many forces.
fn along_world_axes(couples: &[Couple]) -> [Couple; 3] {
    [0, 1, 2].map(|axis| Couple {
        vector: Vector3::ith(axis, 1.0),
        matrix: couples.iter().map(|couple| couple.matrix * couple.vector[axis]).sum(),
    })
}
