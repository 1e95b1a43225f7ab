use super::columns::Columns;
use super::digits::Digits;
use crate::recording::foreign::BodyMapping;
use crate::recording::foreign::attitudes::{self, Quaternion};
use crate::recording::foreign::own::DOUBLE;
use crate::recording::{Axes, Observed, Track};

/// What a body's columns are made into, by their numbers.
#[derive(Debug)]
pub(in crate::recording) struct Parts {
    attitude: Option<Attitude>,
    angular_velocity: Option<[usize; 3]>,
    angular_momentum: Option<[usize; 3]>,
    moment: Option<[usize; 3]>,
    position: Option<[usize; 3]>,
    velocity: Option<[usize; 3]>,
}

#[derive(Debug)]
enum Attitude {
    Quaternion([usize; 4]),
    Mrp([usize; 3]),
    Matrix([usize; 9]),
    Euler([usize; 3], [usize; 3]),
}

/// The numbers of a table.
#[derive(Debug, Default)]
pub(in crate::recording) struct Numbers {
    pub times_s: Vec<f64>,
    /// Column by column, as [`Columns`] numbers them.
    pub columns: Vec<Vec<f64>>,
    pub exactness: Exactness,
}

/// How exact the numbers of a table can be.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::recording) enum Exactness {
    /// They are f64.
    #[default]
    Double,
    /// They are text with so many digits.
    Digits(Digits),
}

impl Parts {
    /// Finds the columns of a body.
    ///
    /// # Errors
    /// Which key names a column that is not there, or says what cannot be.
    pub fn find(body: &BodyMapping, columns: &mut Columns) -> Result<Self, String> {
        let mut vector = |key: &str, names: &Option<[String; 3]>| {
            names.as_ref().map(|names| columns.find_all(key, names)).transpose()
        };
        let angular_velocity = vector("angular_velocity", &body.angular_velocity)?;
        let angular_momentum = vector("angular_momentum", &body.angular_momentum)?;
        let moment = vector("moment", &body.moment)?;
        let (position, velocity) = (vector("position", &body.position)?, vector("velocity", &body.velocity)?);
        let mut attitudes = Vec::new();
        if let Some(names) = &body.quaternion {
            attitudes.push(Attitude::Quaternion(columns.find_all("quaternion", names)?));
        }
        if let Some(names) = &body.mrp {
            attitudes.push(Attitude::Mrp(columns.find_all("mrp", names)?));
        }
        if let Some(names) = &body.matrix {
            attitudes.push(Attitude::Matrix(columns.find_all("matrix", names)?));
        }
        if let Some(names) = &body.euler_angles {
            attitudes.push(Attitude::Euler(columns.find_all("euler_angles", names)?, sequence(body)?));
        }
        if attitudes.len() > 1 {
            return Err("of quaternion, mrp, matrix and euler_angles a body has one".into());
        }
        let attitude = attitudes.pop();
        let parts = Self { attitude, angular_velocity, angular_momentum, moment, position, velocity };
        if parts.attitude.is_none() && angular_velocity.is_none() && angular_momentum.is_none() {
            return Err("a body has an attitude, an angular_velocity or an angular_momentum".into());
        }
        Ok(parts)
    }

    /// The body that they are.
    ///
    /// # Errors
    /// Which sample is no attitude.
    pub fn observed(&self, body: &BodyMapping, numbers: &Numbers) -> Result<Observed, String> {
        let rate = body.angular_velocity_unit.in_rad_s();
        let vector = |parts: Option<[usize; 3]>, unit: f64, axes: Option<Axes>| {
            parts.map(|parts| numbers.track(parts.map(|part| scaled(&numbers.columns[part], unit)), axes))
        };
        Ok(Observed {
            name: body.name.clone().unwrap_or_else(|| "body".into()),
            attitude: self.attitude.as_ref().map(|attitude| attitude.track(body, numbers)).transpose()?,
            angular_velocity: vector(self.angular_velocity, rate, body.angular_velocity_axes),
            angular_momentum: vector(self.angular_momentum, 1.0, body.angular_momentum_axes),
            moment: vector(self.moment, 1.0, body.moment_axes),
            position: vector(self.position, 1.0, Some(Axes::World)),
            velocity: vector(self.velocity, 1.0, body.velocity_axes),
        })
    }
}

impl Attitude {
    fn track(&self, body: &BodyMapping, numbers: &Numbers) -> Result<Track<4>, String> {
        let unit = body.euler_unit.in_rad();
        let mut columns: [Vec<f64>; 4] = Default::default();
        for row in 0..numbers.times_s.len() {
            let found = match self {
                Self::Quaternion(parts) => Some(numbers.row(parts, row)),
                Self::Mrp(parts) => Some(attitudes::from_mrp(numbers.row(parts, row))),
                Self::Matrix(parts) => attitudes::from_matrix(numbers.row(parts, row)),
                Self::Euler(parts, sequence) => {
                    Some(attitudes::from_euler(numbers.row(parts, row).map(|angle| unit * angle), *sequence))
                }
            };
            let found: Quaternion =
                found.ok_or_else(|| format!("sample {row}, at {} s, is no rotation matrix", numbers.times_s[row]))?;
            let turn = attitudes::in_sense(found, body.attitude_sense);
            columns.iter_mut().zip(turn).for_each(|(column, value)| column.push(value));
        }
        if !matches!(self, Self::Quaternion(_)) {
            attitudes::continue_signs(&mut columns);
        }
        Ok(numbers.track(columns, None))
    }
}

impl Numbers {
    fn row<const N: usize>(&self, parts: &[usize; N], row: usize) -> [f64; N] {
        parts.map(|part| self.columns[part][row])
    }

    fn track<const N: usize>(&self, columns: [Vec<f64>; N], axes: Option<Axes>) -> Track<N> {
        let largest = columns.iter().flatten().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let resolution = match self.exactness {
            Exactness::Double => DOUBLE,
            Exactness::Digits(digits) => digits.resolution(largest),
        };
        Track { times_s: self.times_s.clone(), columns, axes, resolution }
    }
}

fn scaled(column: &[f64], unit: f64) -> Vec<f64> {
    column.iter().map(|value| value * unit).collect()
}

/// Axes by number of `ZYX` and the like: three, no two alike side by side.
fn sequence(body: &BodyMapping) -> Result<[usize; 3], String> {
    let rule =
        "euler_sequence is three of X, Y, Z, no two alike side by side: the axes of the body's turns in their order";
    let text = body.euler_sequence.as_deref().ok_or(rule)?;
    let axes: Option<Vec<usize>> = text.chars().map(|axis| "XYZ".find(axis)).collect();
    match axes.as_deref() {
        Some(&[first, second, third]) if first != second && second != third => Ok([first, second, third]),
        _ => Err(format!("{rule}, not {text:?}")),
    }
}
