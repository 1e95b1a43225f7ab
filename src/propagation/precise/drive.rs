use nalgebra::{Matrix3, Vector3};

use super::acting::Vector;
use crate::dynamics::{Cubic, Torque};
use crate::numerics::DoubleDouble;

/// The highest power of time in what changes with time.
const DEGREE: usize = 3;

/// The coefficients of a vector that changes with time, by order.
type Polynomial = [Vector; DEGREE + 1];

const NONE: Polynomial = [[DoubleDouble::ZERO; 3]; DEGREE + 1];

/// A function of time as it holds within a span: a cubic since a knot.
#[derive(Debug, Clone)]
pub(super) struct Driver {
    knot: f64,
    cubic: Cubic,
    form: Form,
}

#[derive(Debug, Clone, Copy)]
enum Form {
    Moment,
    /// A Rᵀ w(t).
    Couple(Matrix3<f64>),
    Rotor,
    /// Force in the body at an arm.
    ForceBody(Vector3<f64>),
    /// Force in the world at an arm.
    ForceWorld(Matrix3<f64>),
}

impl Driver {
    /// Of a load that is a function of time, as it is from `time` on, s.
    pub fn of(torque: &Torque, time: f64) -> Option<Self> {
        let form = match torque {
            Torque::ProfileBody { .. } => Form::Moment,
            Torque::ProfileWorld { .. } => Form::Couple(Matrix3::identity()),
            Torque::ForceProfileBody { arm, .. } => Form::ForceBody(*arm),
            Torque::ForceProfileWorld { arm, .. } => Form::ForceWorld(arm.cross_matrix()),
            Torque::Rotor { .. } => Form::Rotor,
            _ => return None,
        };
        let (knot, cubic) = torque.profile()?.piece(time);
        Some(Self { knot, cubic: *cubic, form })
    }

    /// Whether the motion under it needs the rotation matrix.
    pub fn needs_matrix(&self, moves: bool) -> bool {
        match self.form {
            Form::Moment | Form::Rotor => false,
            Form::Couple(_) => true,
            Form::ForceBody(_) => moves,
            Form::ForceWorld(matrix) => matrix != Matrix3::zeros(),
        }
    }

    /// Its polynomial in σ = (t − `time`) / `unit`.
    fn about(&self, time: DoubleDouble, unit: f64) -> Polynomial {
        let passed = time - DoubleDouble::from(self.knot);
        let mut polynomial = NONE;
        for (order, coefficient) in self.cubic.iter().enumerate() {
            polynomial[order] = <[f64; 3]>::from(*coefficient).map(DoubleDouble::from);
        }
        // Horner's scheme, again and again: the coefficients about a later time.
        for lowest in 0..DEGREE {
            for order in (lowest..DEGREE).rev() {
                for axis in 0..3 {
                    let above = polynomial[order + 1][axis];
                    polynomial[order][axis] += above * passed;
                }
            }
        }
        let mut power = 1.0;
        for coefficient in &mut polynomial {
            // Of a body at rest for ever the unit's powers may be infinite; zero stays zero.
            *coefficient = coefficient.map(|value| if value.is_zero() { value } else { value.scale(power) });
            power *= unit;
        }
        polynomial
    }
}

/// All that changes with time, about the start of one step, divided by moments of inertia and mass.
#[derive(Debug, Clone)]
pub(super) struct Drive {
    /// I⁻¹ (τ − ḣ).
    pub moment: Polynomial,
    /// I⁻¹ A w for each order and each world axis, by rows.
    pub couples: [[[Vector; 3]; 3]; DEGREE + 1],
    /// h.
    pub rotor: Polynomial,
    pub body_acceleration: Polynomial,
    pub world_acceleration: Polynomial,
    inertia: Vector,
}

impl Drive {
    /// Of `drivers`, about `time`, for a series in `unit` seconds; `mass` where a translation is wanted.
    pub fn new(drivers: &[Driver], inertia: Vector, mass: Option<DoubleDouble>, time: DoubleDouble, unit: f64) -> Self {
        let mut drive = Self {
            moment: NONE,
            couples: [[[[DoubleDouble::ZERO; 3]; 3]; 3]; DEGREE + 1],
            rotor: NONE,
            body_acceleration: NONE,
            world_acceleration: NONE,
            inertia,
        };
        for driver in drivers {
            let polynomial = driver.about(time, unit);
            match driver.form {
                Form::Moment => drive.add_moment(&polynomial),
                Form::Couple(matrix) => drive.add_couple(&matrix, &polynomial),
                Form::Rotor => drive.add_rotor(&polynomial, unit),
                Form::ForceBody(arm) => {
                    drive.add_moment(&polynomial.map(|force| cross(arm, force)));
                    add_over(&mut drive.body_acceleration, &polynomial, mass);
                }
                Form::ForceWorld(matrix) => {
                    drive.add_couple(&matrix, &polynomial);
                    add_over(&mut drive.world_acceleration, &polynomial, mass);
                }
            }
        }
        drive
    }

    fn add_moment(&mut self, moment: &Polynomial) {
        for (sum, coefficient) in self.moment.iter_mut().zip(moment) {
            for axis in 0..3 {
                sum[axis] += coefficient[axis] / self.inertia[axis];
            }
        }
    }

    fn add_couple(&mut self, matrix: &Matrix3<f64>, vector: &Polynomial) {
        for (axes, coefficient) in self.couples.iter_mut().zip(vector) {
            for (axis, rows) in axes.iter_mut().enumerate() {
                for i in 0..3 {
                    for j in 0..3 {
                        rows[i][j] += coefficient[axis] * matrix[(i, j)] / self.inertia[i];
                    }
                }
            }
        }
    }

    fn add_rotor(&mut self, momentum: &Polynomial, unit: f64) {
        let mut factor = 0.0;
        for order in 0..=DEGREE {
            for axis in 0..3 {
                self.rotor[order][axis] += momentum[order][axis];
                if order > 0 {
                    let spin_up = (momentum[order][axis] * factor).scale(1.0 / unit);
                    self.moment[order - 1][axis] = self.moment[order - 1][axis] - spin_up / self.inertia[axis];
                }
            }
            factor += 1.0;
        }
    }

    /// Coefficient k of what it adds to ω̇, from those of ω and of the rotation matrix up to k.
    pub fn rates<const N: usize>(
        &self,
        rates: &[[DoubleDouble; N]; 3],
        matrix: &[[[DoubleDouble; N]; 3]; 3],
        needs_matrix: bool,
        k: usize,
    ) -> Vector {
        let mut sum = self.moment.get(k).copied().unwrap_or([DoubleDouble::ZERO; 3]);
        for order in 0..=k.min(DEGREE) {
            let (h, before) = (self.rotor[order], k - order);
            for (i, sum) in sum.iter_mut().enumerate() {
                let (next, last) = ((i + 1) % 3, (i + 2) % 3);
                *sum += (h[next] * rates[last][before] - h[last] * rates[next][before]) / self.inertia[i];
                if needs_matrix {
                    for (rows, image) in self.couples[order].iter().zip(matrix) {
                        for (factor, component) in rows[i].iter().zip(image).filter(|(factor, _)| !factor.is_zero()) {
                            *sum += *factor * component[before];
                        }
                    }
                }
            }
        }
        sum
    }

    /// Coefficient k of what it adds to v̇.
    pub fn acceleration<const N: usize>(&self, matrix: &[[[DoubleDouble; N]; 3]; 3], k: usize) -> Vector {
        let mut sum = self.world_acceleration.get(k).copied().unwrap_or([DoubleDouble::ZERO; 3]);
        for order in 0..=k.min(DEGREE) {
            for (sum, row) in sum.iter_mut().zip(matrix) {
                for (component, along) in row.iter().zip(self.body_acceleration[order]) {
                    if !along.is_zero() {
                        *sum += component[k - order] * along;
                    }
                }
            }
        }
        sum
    }

    /// How fast rotors turn the body, 1/s.
    pub fn turning(&self) -> f64 {
        let [h, ..] = self.rotor;
        let least = self.inertia.iter().fold(f64::INFINITY, |least, moment| least.min(moment.hi()));
        h.iter().fold(0.0, |most: f64, value| most.max(value.hi().abs())) / least
    }
}

/// arm × force.
fn cross(arm: Vector3<f64>, force: Vector) -> Vector {
    std::array::from_fn(|i| {
        let (next, last) = ((i + 1) % 3, (i + 2) % 3);
        force[last] * arm[next] - force[next] * arm[last]
    })
}

/// Adds a force over the mass, where a translation is wanted.
fn add_over(sum: &mut Polynomial, force: &Polynomial, mass: Option<DoubleDouble>) {
    let Some(mass) = mass else { return };
    for (sum, coefficient) in sum.iter_mut().flatten().zip(force.iter().flatten()) {
        *sum += *coefficient / mass;
    }
}
