use std::f64::consts::PI;
use std::fmt;

use super::{Limits, Pose};
use crate::comparison::{Growth, Trace};

/// How far a simulation was from a golden. Its text is for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// What it was held to.
    pub golden: String,
    /// The limits that it was held to.
    pub limits: Limits,
    /// The largest angle between the attitudes, rad.
    pub attitude: Option<Worst>,
    /// The largest difference between the angular velocities, rad/s, if both tell them.
    pub angular_velocity: Option<Worst>,
    /// How far the simulation's quaternions were from unit length at most. It is no error of the attitude.
    pub off_unit: f64,
    /// By which law the angle between the attitudes grows, if that can be told.
    pub growth: Option<Growth>,
    /// Where a limit was left, if it was.
    pub first: Option<Divergence>,
    /// The difference at every time compared.
    pub rows: Vec<Row>,
}

/// The largest difference, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// In the quantity's unit; infinite where a number was none.
    pub difference: f64,
    /// s.
    pub at_s: f64,
}

/// Where a simulation first leaves a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Divergence {
    /// In what.
    pub quantity: Quantity,
    /// When, s.
    pub time_s: f64,
    /// Number of the sample, from 0.
    pub sample: usize,
    /// What the golden says.
    pub expected: Pose,
    /// What the simulation says.
    pub simulated: Pose,
    /// How far apart, in the quantity's unit.
    pub difference: f64,
    /// How far it may be.
    pub limit: f64,
}

/// What is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// By angle, rad.
    Attitude,
    /// By the length of the difference, rad/s.
    AngularVelocity,
}

/// The differences at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// s.
    pub time_s: f64,
    /// Between the attitudes, rad, 0 to π; infinite where one is no number.
    pub attitude_rad: f64,
    /// Between the angular velocities, rad/s; `None` where one of them is not told.
    pub angular_velocity_rad_s: Option<f64>,
}

impl Quantity {
    /// Name and unit.
    #[must_use]
    pub const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Attitude => ("attitude", "rad"),
            Self::AngularVelocity => ("angular velocity", "rad/s"),
        }
    }
}

impl Report {
    /// Rows shown before and after the one that matters.
    const ABOUT: usize = 3;

    pub(super) fn new(
        golden: String,
        limits: Limits,
        rows: Vec<Row>,
        first: Option<Divergence>,
        off_unit: f64,
    ) -> Self {
        let attitude = worst(rows.iter().map(|row| (row.time_s, row.attitude_rad)));
        let angular_velocity = worst(rows.iter().filter_map(|row| Some((row.time_s, row.angular_velocity_rad_s?))));
        let mut trace = Trace::default();
        for row in &rows {
            trace.push(row.time_s, row.attitude_rad);
        }
        let growth = Growth::of(&trace, PI);
        Self { golden, limits, attitude, angular_velocity, off_unit, growth, first, rows }
    }

    /// The rows about the first divergence, or about the worst.
    fn shown(&self) -> (usize, &[Row]) {
        let is_worst = |row: &Row| self.attitude.is_some_and(|worst| worst.at_s == row.time_s);
        let middle = match &self.first {
            Some(first) => first.sample,
            None => self.rows.iter().position(is_worst).unwrap_or(0),
        };
        let from = middle.saturating_sub(Self::ABOUT);
        let to = self.rows.len().min(middle + Self::ABOUT + 1);
        (middle - from, self.rows.get(from..to).unwrap_or(&[]))
    }
}

/// The first of the largest.
fn worst(differences: impl Iterator<Item = (f64, f64)>) -> Option<Worst> {
    let larger = |worst: Option<Worst>, (at_s, difference)| match worst {
        Some(worst) if worst.difference >= difference => Some(worst),
        _ => Some(Worst { difference, at_s }),
    };
    differences.fold(None, larger)
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (samples, end) = (self.rows.len(), self.rows.last().map_or(0.0, |row| row.time_s));
        match &self.first {
            None => {
                writeln!(f, "the motion of {}, within its limits: {samples} samples to {} s", self.golden, short(end))?;
            }
            Some(first) => {
                writeln!(f, "not the motion of {}: {first}, sample {} of {samples}", self.golden, first.sample + 1)?;
                first.write_values(f)?;
            }
        }
        let worst = [(Quantity::Attitude, self.attitude), (Quantity::AngularVelocity, self.angular_velocity)];
        for (quantity, worst) in worst {
            let (name, unit) = quantity.words();
            if let Some(Worst { difference, at_s }) = worst {
                writeln!(f, "  {:24}{difference:.3e} {unit} at {} s", format!("worst {name}"), short(at_s))?;
            }
        }
        if let Some(growth) = &self.growth {
            writeln!(f, "  {:24}{}", "the attitude's error", growth.in_words())?;
        }
        if self.off_unit > Self::UNIT {
            writeln!(f, "  {:24}off unit length by up to {:.1e}", "quaternion", self.off_unit)?;
        }
        self.write_table(f)
    }
}

impl Report {
    /// Roundings of a product of unit quaternions are no news.
    const UNIT: f64 = 1e-14;

    fn write_table(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (marked, rows) = self.shown();
        write!(f, "\n    {:<16}{:<16}angular velocity rad/s", "time s", "attitude rad")?;
        for (number, row) in rows.iter().enumerate() {
            let mark = if number == marked { '>' } else { ' ' };
            let rates = row.angular_velocity_rad_s.map_or_else(|| "–".into(), |rates| format!("{rates:.3e}"));
            write!(f, "\n  {mark} {:<16}{:<16}{rates}", short(row.time_s), format!("{:.3e}", row.attitude_rad))?;
        }
        Ok(())
    }
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} first out of its limit at {} s", self.quantity.words().0, short(self.time_s))
    }
}

impl Divergence {
    fn write_values(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (_, unit) = self.quantity.words();
        for (who, pose) in [("expected", &self.expected), ("simulated", &self.simulated)] {
            let value = match self.quantity {
                Quantity::Attitude => format!("w, x, y, z = {:?}", pose.attitude_wxyz()),
                Quantity::AngularVelocity if self.simulated.is_turning_in_world() => {
                    told("world", pose.angular_velocity_in_world())
                }
                Quantity::AngularVelocity => told("body", pose.angular_velocity_in_body()),
            };
            writeln!(f, "  {who:24}{value}")?;
        }
        writeln!(f, "  {:24}{:.3e} {unit}, limit {:e} {unit}", "difference", self.difference, self.limit)
    }
}

fn told(axes: &str, rates: Option<[f64; 3]>) -> String {
    rates.map_or_else(|| "not told".into(), |rates| format!("{rates:?} rad/s in {axes} axes"))
}

/// A time without the roundings of its last digits.
fn short(time_s: f64) -> f64 {
    format!("{time_s:.11e}").parse().unwrap_or(time_s)
}
