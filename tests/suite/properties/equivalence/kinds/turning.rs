//! The same load in other units, in other body axes, in a turned world, from a later time on.

use nalgebra::{Matrix3, UnitQuaternion};

use super::{Kind, Span, Vector};

fn conjugated(matrix: &Matrix3<f64>, turn: &UnitQuaternion<f64>) -> Matrix3<f64> {
    let turn = turn.to_rotation_matrix().into_inner();
    turn * matrix * turn.transpose()
}

impl Kind {
    /// Of a body of this least moment and mass: moments and momenta are in units of the one, forces of the other.
    pub fn scaled(self, least: f64, mass: f64) -> Self {
        match self {
            Self::ConstantBody(moment) => Self::ConstantBody(moment * least),
            Self::ConstantWorld(moment) => Self::ConstantWorld(moment * least),
            Self::LinearDamping(coefficient) => Self::LinearDamping(coefficient * least),
            Self::Dipole { dipole, field } => Self::Dipole { dipole: dipole * least, field },
            Self::Table { rows, is_world, interpolation, holds, point } => {
                let unit = if point.is_some() { least.min(mass) } else { least };
                let rows = rows.into_iter().map(|(time, vector)| (time, vector * unit)).collect();
                Self::Table { rows, is_world, interpolation, holds, point }
            }
            Self::ForceBody { force, point } => Self::ForceBody { force: force * least, point },
            Self::ForceWorld { force, point } => Self::ForceWorld { force: force * least, point },
            Self::Thruster { direction, thrust, point, pulses } => {
                Self::Thruster { direction, thrust: thrust * least, point, pulses }
            }
            Self::Spring { anchor, point, stiffness, rest, damping, is_tether } => {
                let [stiffness, damping] = [stiffness, damping].map(|value| value * least);
                Self::Spring { anchor, point, stiffness, rest, damping, is_tether }
            }
            Self::Drag { coefficient, point } => Self::Drag { coefficient: coefficient * least, point },
            Self::QuadraticDamping(coefficient) => Self::QuadraticDamping(coefficient * least),
            Self::Sphere { inertia, coefficient, relative } => {
                Self::Sphere { inertia: inertia * least, coefficient: coefficient * least, relative }
            }
            Self::Feedback { target, stiffness, damping, limit, dead_band } => Self::Feedback {
                target,
                stiffness: stiffness * least,
                damping: damping * least,
                limit: limit.map(|limit| limit * least),
                dead_band: dead_band * least,
            },
            Self::RateFeedback { gain, limit } => {
                Self::RateFeedback { gain: gain * least, limit: limit.map(|limit| limit * least) }
            }
            Self::BDot { field, turning, gain, limit } => {
                Self::BDot { field, turning, gain: gain * least, limit: limit.map(|limit| limit * least) }
            }
            Self::Rotor { axis, momenta } => {
                Self::Rotor { axis, momenta: momenta.into_iter().map(|(time, size)| (time, size * least)).collect() }
            }
            Self::FormulaBody { matrix, swing, beat, world } => {
                Self::FormulaBody { matrix: matrix * least, swing: swing * least, beat, world: world * least }
            }
            Self::FormulaWorld { matrix, swing, beat, body } => {
                Self::FormulaWorld { matrix: matrix * least, swing: swing * least, beat, body }
            }
            Self::FormulaForce { pull, anchor, swing, beat, point } => {
                Self::FormulaForce { pull: pull.map(|value| value * least), anchor, swing: swing * least, beat, point }
            }
            other @ (Self::MomentumBrake(_) | Self::Gradient { .. }) => other,
        }
    }

    /// How large it is, about, N m or N: what its numbers' roundings are measured by.
    pub fn size(&self) -> f64 {
        match self {
            Self::ConstantBody(vector)
            | Self::ConstantWorld(vector)
            | Self::ForceBody { force: vector, .. }
            | Self::ForceWorld { force: vector, .. } => vector.norm(),
            Self::Table { rows, .. } => rows.iter().map(|(_, vector)| vector.norm()).fold(0.0, f64::max),
            Self::Dipole { dipole, field } => dipole.norm() * field.norm(),
            Self::Thruster { thrust, .. } => *thrust,
            Self::Spring { anchor, stiffness, damping, .. } => (stiffness + damping) * (1.0 + anchor.norm()),
            Self::Feedback { stiffness, damping, .. } => stiffness + damping,
            Self::LinearDamping(value)
            | Self::QuadraticDamping(value)
            | Self::Drag { coefficient: value, .. }
            | Self::Sphere { coefficient: value, .. }
            | Self::RateFeedback { gain: value, .. }
            | Self::BDot { gain: value, .. } => *value,
            Self::Rotor { momenta, .. } => 10.0 * momenta.iter().map(|pair| pair.1.abs()).fold(0.0, f64::max),
            Self::FormulaBody { matrix, swing, world, .. } => matrix.norm() + swing.norm() + world.norm(),
            Self::FormulaWorld { matrix, swing, body, .. } => matrix.norm() * body.norm() + swing.norm(),
            Self::FormulaForce { pull, anchor, swing, .. } => {
                (pull[0] + pull[1]) * (1.0 + anchor.norm()) + swing.norm()
            }
            Self::MomentumBrake(_) | Self::Gradient { .. } => 0.0,
        }
    }

    /// In other body axes: `turn` takes components along the old to those along the new. What a scene holds within limits
    /// about each body axis is another load about others.
    pub fn in_axes(&self, turn: &UnitQuaternion<f64>) -> Self {
        let mut kind = self.clone();
        match &mut kind {
            Self::ConstantBody(vector)
            | Self::Dipole { dipole: vector, .. }
            | Self::Sphere { relative: vector, .. }
            | Self::Rotor { axis: vector, .. }
            | Self::FormulaWorld { body: vector, .. } => *vector = turn * *vector,
            Self::Table { rows, is_world, point, .. } => {
                for (_, vector) in rows.iter_mut().filter(|_| !*is_world) {
                    *vector = turn * *vector;
                }
                *point = point.map(|point| turn * point);
            }
            Self::ForceBody { force: vector, point } | Self::Thruster { direction: vector, point, .. } => {
                (*vector, *point) = (turn * *vector, turn * *point);
            }
            Self::ForceWorld { point, .. }
            | Self::Spring { point, .. }
            | Self::Drag { point, .. }
            | Self::FormulaForce { point, .. } => *point = turn * *point,
            Self::Feedback { target, .. } => *target *= turn.inverse(),
            Self::FormulaBody { matrix, swing, .. } => {
                (*matrix, *swing) = (conjugated(matrix, turn), turn * *swing);
            }
            _ => {}
        }
        kind
    }

    /// Without limits and bands about body axes.
    pub fn unlimited(mut self) -> Self {
        match &mut self {
            Self::Feedback { limit, dead_band, .. } => (*limit, *dead_band) = (None, 0.0),
            Self::RateFeedback { limit, .. } | Self::BDot { limit, .. } => *limit = None,
            _ => {}
        }
        self
    }

    /// In a turned world. An orbit stays in the plane where scenes have it.
    pub fn turned(&self, turn: &UnitQuaternion<f64>) -> Self {
        let mut kind = self.clone();
        match &mut kind {
            Self::ConstantWorld(vector)
            | Self::Dipole { field: vector, .. }
            | Self::ForceWorld { force: vector, .. }
            | Self::Spring { anchor: vector, .. }
            | Self::FormulaBody { world: vector, .. } => *vector = turn * *vector,
            Self::Table { rows, is_world: true, .. } => {
                for (_, vector) in rows {
                    *vector = turn * *vector;
                }
            }

            Self::Feedback { target, .. } => *target = turn * *target,
            Self::BDot { field: one, turning: other, .. } | Self::FormulaForce { anchor: one, swing: other, .. } => {
                (*one, *other) = (turn * *one, turn * *other);
            }
            Self::FormulaWorld { matrix, swing, .. } => (*matrix, *swing) = (conjugated(matrix, turn), turn * *swing),
            _ => {}
        }
        kind
    }

    /// As it is told by who begins to count at `from`, s.
    pub fn later(&self, from: f64) -> Self {
        let mut kind = self.clone();
        match &mut kind {
            Self::Table { rows, .. } => {
                for (time, _) in rows {
                    *time -= from;
                }
            }
            Self::Rotor { momenta, .. } => {
                for (time, _) in momenta {
                    *time -= from;
                }
            }
            Self::Thruster { pulses, .. } => {
                pulses.retain(|pulse| pulse[1] > from);
                for pulse in pulses {
                    (pulse[0], pulse[1]) = ((pulse[0] - from).max(0.0), pulse[1] - from);
                }
            }
            Self::BDot { field, turning, .. } => *field = UnitQuaternion::from_scaled_axis(*turning * from) * *field,
            Self::FormulaBody { beat, .. } | Self::FormulaWorld { beat, .. } | Self::FormulaForce { beat, .. } => {
                beat[1] += beat[0] * from;
            }
            _ => {}
        }
        kind
    }

    /// Whether a scene can tell from when to when it acts.
    pub fn has_span(&self) -> bool {
        !matches!(self, Self::Sphere { .. } | Self::Rotor { .. })
    }
}

/// The same span from a later time on, if any is left.
pub fn later(&[start, end]: &Span, from: f64) -> Option<Span> {
    let is_left = end.is_none_or(|end| end > from);
    is_left.then(|| [start.filter(|start| *start > from).map(|start| start - from), end.map(|end| end - from)])
}

/// A point of the world from which an orbit's phase counts: the turn that begins it anew at `from`, s.
pub fn begun(mean_motion: f64, from: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(Vector::z() * (-mean_motion * from))
}
