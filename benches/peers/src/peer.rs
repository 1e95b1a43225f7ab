use ode_solvers::{Dop853, OutputType, SVector, System};
use polhode::propagation::States;

use crate::cases::Case;

/// w, x, y, z, then the rates.
type State = SVector<f64, 7>;

struct Equations<'case>(&'case Case);

impl System<f64, State> for Equations<'_> {
    fn system(&self, _time: f64, state: &State, derivative: &mut State) {
        let Case { moments: [i1, i2, i3], moment: [m1, m2, m3], top, .. } = *self.0;
        let [w, x, y, z, p, q, r] = (*state).into();
        // Gravity down −z on a point of the body's z axis: e₃ × Rᵀ(−z), times m g l.
        let (t1, t2) = (top * 2.0 * (y * z + w * x), -top * 2.0 * (x * z - w * y));
        *derivative = State::from([
            0.5 * (-x * p - y * q - z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            (m1 + t1 + (i2 - i3) * q * r) / i1,
            (m2 + t2 + (i3 - i1) * r * p) / i2,
            (m3 + (i1 - i2) * p * q) / i3,
        ]);
    }
}

/// ode_solvers' DOP853 from output to output, keeping its steps: its dense output is wrong in its last sample where
/// outputs lie further apart than steps. `None` where it gives up.
pub fn dop853(case: &Case, times: &[f64], tolerance: f64) -> Option<States> {
    let mut states = States::default();
    states.reset(times.len(), true, false);
    let ([w, x, y, z], [p, q, r]) = (case.attitude, case.rates);
    let (mut time, mut state) = (0.0, State::from([w, x, y, z, p, q, r]));
    for (row, &end) in times.iter().enumerate() {
        let mut stepper = Dop853::new(Equations(case), time, end, end - time, state, tolerance, tolerance);
        stepper.set_output(OutputType::Sparse);
        stepper.integrate().ok()?;
        state = *stepper.y_out().last()?;
        for (column, value) in states.attitude.iter_mut().zip(state.iter()) {
            column[row] = *value;
        }
        for (column, value) in states.angular_velocity.iter_mut().zip(state.iter().skip(4)) {
            column[row] = *value;
        }
        time = end;
    }
    Some(states)
}
