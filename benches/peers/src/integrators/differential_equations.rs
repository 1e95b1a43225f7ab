use differential_equations::ivp::IVP;
use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::ODE;
use polhode::propagation::States;

use crate::cases::Case;
use crate::peer::{Peer, empty_states, keep, tolerances};

/// Its method of order 8 or of order 9, over the whole case with outputs by the method's interpolant, or from output to
/// output: the first is cheaper where outputs lie close, the second more accurate.
pub struct DifferentialEquations {
    pub method: Method,
    pub outputs: Outputs,
}

#[derive(Clone, Copy)]
pub enum Method {
    Dop853,
    /// Verner's 9(8) pair, with its interpolant of order 9.
    Rkv989e,
}

#[derive(Clone, Copy)]
pub enum Outputs {
    Interpolated,
    Stepped,
}

struct Equations<'case>(&'case Case);

impl ODE<f64, [f64; 7]> for Equations<'_> {
    fn diff(&self, _time: f64, state: &[f64; 7], derivative: &mut [f64; 7]) {
        *derivative = self.0.derivative(*state);
    }
}

/// More than any case needs: its own limit of 10,000 would stop tight runs.
const STEPS_MAX: usize = 10_000_000;

impl DifferentialEquations {
    /// From `start` at `from`, the states at `times`.
    fn solve(&self, case: &Case, tolerance: f64, from: f64, start: [f64; 7], times: &[f64]) -> Option<Vec<[f64; 7]>> {
        let equations = Equations(case);
        let problem = IVP::ode(&equations, from, *times.last()?, start).t_eval(times);
        let solved = match self.method {
            Method::Dop853 => {
                let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(STEPS_MAX);
                problem.method(method).solve()
            }
            Method::Rkv989e => {
                let method = ExplicitRungeKutta::rkv989e().rtol(tolerance).atol(tolerance).max_steps(STEPS_MAX);
                problem.method(method).solve()
            }
        };
        solved.ok().map(|solution| solution.y).filter(|found| found.len() == times.len())
    }
}

impl Peer for DifferentialEquations {
    fn name(&self) -> &'static str {
        "differential-equations"
    }

    fn way(&self) -> String {
        let method = match self.method {
            Method::Dop853 => "dop853",
            Method::Rkv989e => "rkv989e",
        };
        match self.outputs {
            Outputs::Interpolated => format!("{method} interpolated"),
            Outputs::Stepped => method.into(),
        }
    }

    fn settings(&self, _: &Case) -> Vec<f64> {
        tolerances()
    }

    fn states(&self, case: &Case, tolerance: f64) -> Option<States> {
        let times = case.times();
        let in_one_run = match self.outputs {
            Outputs::Interpolated => times.len(),
            Outputs::Stepped => 1,
        };
        let mut states = empty_states(case);
        let (mut from, mut start, mut row) = (0.0, case.start(), 0);
        for times in times.chunks(in_one_run) {
            for found in self.solve(case, tolerance, from, start, times)? {
                keep(&mut states, row, found);
                (start, row) = (found, row + 1);
            }
            from = *times.last()?;
        }
        Some(states)
    }
}
