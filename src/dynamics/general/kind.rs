use super::{FormulaLoad, Push, Symbols};
use crate::numerics::Tape;

/// What acts, of kinds that need more than constants, couples and damping.
#[derive(Debug, Clone, PartialEq)]
pub enum General {
    /// A moment or a force by formulae.
    Formula(FormulaLoad),
}

impl General {
    /// Its moment and force, as operations.
    pub fn lay_out(&self, tape: &mut Tape, symbols: &Symbols) -> Push {
        match self {
            Self::Formula(load) => load.lay_out(tape, symbols),
        }
    }

    /// Whether it depends on where the reference point is, or how fast it moves.
    #[must_use]
    pub fn looks_at_translation(&self) -> bool {
        match self {
            Self::Formula(load) => load.looks_at_translation(),
        }
    }

    /// Whether it pushes the reference point.
    #[must_use]
    pub fn pushes(&self) -> bool {
        match self {
            Self::Formula(load) => load.pushes(),
        }
    }

    /// What it is, for people.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Formula(load) => load.name(),
        }
    }
}
