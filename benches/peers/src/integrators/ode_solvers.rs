use ode_solvers::{Dop853, OutputType, SVector, System};
use polhode::propagation::States;

use crate::cases::Case;
use crate::peer::{Peer, empty_states, keep, tolerances};

/// From output to output, keeping its steps: its dense output is wrong in its last sample where outputs lie further
/// apart than steps.
pub struct OdeSolvers;

type State = SVector<f64, 7>;

struct Equations<'case>(&'case Case);

impl System<f64, State> for Equations<'_> {
    fn system(&self, _time: f64, state: &State, derivative: &mut State) {
        *derivative = State::from(self.0.derivative((*state).into()));
    }
}

impl Peer for OdeSolvers {
    fn name(&self) -> &'static str {
        "ode_solvers"
    }

    fn way(&self) -> String {
        "Dop853".into()
    }

    fn settings(&self, _: &Case) -> Vec<f64> {
        tolerances()
    }

    fn states(&self, case: &Case, tolerance: f64) -> Option<States> {
        let mut states = empty_states(case);
        let (mut time, mut state) = (0.0, State::from(case.start()));
        for (row, &end) in case.times().iter().enumerate() {
            let mut stepper = Dop853::new(Equations(case), time, end, end - time, state, tolerance, tolerance);
            stepper.set_output(OutputType::Sparse);
            stepper.integrate().ok()?;
            state = *stepper.y_out().last()?;
            keep(&mut states, row, state.into());
            time = end;
        }
        Some(states)
    }
}
