use nalgebra::{UnitQuaternion, Vector3};

use super::axes::{rotated, times_inverse};
use super::{Push, Symbols};
use crate::dynamics::formula::{Expression, Known, Variable};
use crate::numerics::Tape;

/// A moment or a force whose components are formulae.
#[derive(Debug, Clone, PartialEq)]
pub struct FormulaLoad {
    /// x, y and z: N m or N.
    pub components: [Expression; 3],
    /// Whether the components are along world axes, and not along the body's.
    pub in_world: bool,
    /// Moment or force.
    pub place: FormulaPlace,
    /// The body axes that the formulae speak of.
    pub body_from_principal: UnitQuaternion<f64>,
}

/// What the formulae are of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FormulaPlace {
    /// A moment.
    Moment,
    /// A force.
    Force {
        /// Where it acts, in principal axes, m.
        arm: Vector3<f64>,
    },
}

impl FormulaLoad {
    pub(super) fn lay_out(&self, tape: &mut Tape, symbols: &Symbols) -> Push {
        let known = self.known(tape, symbols);
        let components = self.components.each_ref().map(|component| component.on(tape, &known));
        match (self.place, self.in_world) {
            (FormulaPlace::Moment, true) => {
                let moment = symbols.to_body(tape, components);
                Push::moment(tape, moment)
            }
            (FormulaPlace::Moment, false) => {
                let moment = rotated(tape, self.body_from_principal.inverse(), components);
                Push::moment(tape, moment)
            }
            (FormulaPlace::Force { arm }, true) => Push::force(tape, symbols, components, arm),
            (FormulaPlace::Force { arm }, false) => {
                let in_principal = rotated(tape, self.body_from_principal.inverse(), components);
                let force = symbols.to_world(tape, in_principal);
                Push::force(tape, symbols, force, arm)
            }
        }
    }

    /// The motion in the axes that the formulae speak of.
    fn known(&self, tape: &mut Tape, symbols: &Symbols) -> Known {
        let turn = self.body_from_principal;
        Known {
            time: symbols.time,
            rates: rotated(tape, turn, symbols.rates),
            quaternion: times_inverse(tape, symbols.attitude, turn),
            // A row is the body image of a world axis.
            matrix: symbols.matrix.map(|row| rotated(tape, turn, row)),
            position: symbols.position,
            velocity: symbols.velocity,
        }
    }

    pub(super) fn looks_at_translation(&self) -> bool {
        let is_translation = |variable: Variable| matches!(variable, Variable::Position(_) | Variable::Velocity(_));
        self.components.iter().any(|component| component.names(&is_translation))
    }

    pub(super) const fn pushes(&self) -> bool {
        matches!(self.place, FormulaPlace::Force { .. })
    }

    pub(super) const fn name(&self) -> &'static str {
        match self.place {
            FormulaPlace::Moment => "torque by formula",
            FormulaPlace::Force { .. } => "force by formula",
        }
    }
}
