use nalgebra::Vector3;

use super::{General, Push, Symbols};
use crate::body::State;
use crate::numerics::{Expansion, Tape};

/// A load of a general kind, with its operations laid out for single instants.
#[derive(Debug, Clone, PartialEq)]
pub struct GeneralLoad {
    /// What acts.
    pub kind: General,
    tape: Tape,
}

impl GeneralLoad {
    /// Of a kind.
    #[must_use]
    pub fn new(kind: General) -> Self {
        let mut tape = Tape::new(Symbols::INPUTS);
        let symbols = Symbols::on(&mut tape);
        // What a sphere inside does to the body it does to itself: nothing from outside.
        let Push { moment, force } = match kind {
            General::InnerSphere(_) => Push::none(&mut tape),
            _ => kind.lay_out(&mut tape, &symbols),
        };
        for node in moment.into_iter().chain(force) {
            tape.want(node);
        }
        Self { kind, tape }
    }

    /// About the reference point at `time` in s, N m; principal axes.
    #[must_use]
    pub fn moment(&self, time: f64, state: &State) -> Vector3<f64> {
        let [moment, _] = self.at(time, state);
        moment
    }

    /// On the reference point at `time` in s, N; world axes.
    #[must_use]
    pub fn force(&self, time: f64, state: &State) -> Vector3<f64> {
        let [_, force] = self.at(time, state);
        force
    }

    /// Moment and force.
    fn at(&self, time: f64, state: &State) -> [Vector3<f64>; 2] {
        let mut expansion = Expansion::<f64>::new(&self.tape, 0);
        for (input, value) in Symbols::values(time, state).into_iter().enumerate() {
            expansion.set(input, 0, value);
        }
        expansion.expand(&self.tape, 0);
        let three = |first: usize| Vector3::from_fn(|row, _| expansion.output(&self.tape, first + row)[0]);
        [three(0), three(3)]
    }
}
